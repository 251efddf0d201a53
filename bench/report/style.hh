/// \file
/// How the HTML report looks: light and dark, on a phone and on paper.
#pragma once

namespace whittle::bench {

constexpr char kStyle[] = R"(
:root{color-scheme:light dark;--page:#fbfaf8;--card:#fff;--ink:#22272c;--soft:#5c646d;--line:#e1e0dc;--stripe:#f5f4f0;
--accent:#0b5f8a;--good:#1d6b3c;--good-b:#e2f2e7;--bad:#98231d;--bad-b:#fbe6e3;--odd:#7a5200;--odd-b:#fdf0d5;
--none:#4f565d;--none-b:#e9eaec}
@media(prefers-color-scheme:dark){:root{--page:#14171a;--card:#1c2024;--ink:#e4e7ea;--soft:#a3abb4;--line:#333a42;
--stripe:#22272c;--accent:#7cc5ef;--good:#8fdcab;--good-b:#173524;--bad:#ffa39b;--bad-b:#431d1a;--odd:#f3cd84;
--odd-b:#3d2f10;--none:#c3c9cf;--none-b:#30363c}}
*{box-sizing:border-box}
body{margin:0;background:var(--page);color:var(--ink);font:16px/1.55 system-ui,-apple-system,"Segoe UI","DejaVu Sans",sans-serif}
header,main,footer{max-width:1240px;margin:0 auto;padding:0 20px}
header{padding-top:34px}
h1{font-size:1.9rem;line-height:1.2;margin:0 0 6px}
h2{font-size:1.35rem;margin:0 0 14px;line-height:1.25}
.summary{color:var(--soft);margin:0 0 16px}
nav{display:flex;flex-wrap:wrap;gap:6px 8px;margin:0 0 22px}
nav a{color:var(--accent);text-decoration:none;border:1px solid var(--line);border-radius:999px;padding:3px 12px;
font-size:.88rem;background:var(--card)}
nav a:hover{border-color:var(--accent)}
section{background:var(--card);border:1px solid var(--line);border-radius:12px;padding:22px 24px;margin:0 0 22px}
p{max-width:78ch;margin:0 0 16px}
code{background:var(--stripe);border-radius:4px;padding:1px 5px;font-size:.9em}
.note{border-left:4px solid var(--odd);background:var(--odd-b);padding:10px 14px;border-radius:0 8px 8px 0;
margin:0 0 16px;font-size:.93rem;overflow-wrap:anywhere}
figure{margin:0 0 24px}
figcaption{color:var(--soft);font-size:.9rem;margin:0 0 8px;max-width:90ch}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:8px}
table{border-collapse:collapse;width:100%;font-size:.86rem;font-variant-numeric:tabular-nums}
th,td{padding:6px 10px;text-align:right;white-space:nowrap;border-bottom:1px solid var(--line)}
th{font-weight:600;color:var(--soft);background:var(--stripe);white-space:normal;vertical-align:bottom}
td.t,th.t{text-align:left}
td.t{white-space:normal;min-width:13em;overflow-wrap:break-word}
#paper2 td.t{min-width:6em}#peers td.t{min-width:10em}#verdicts td:first-child{min-width:17em}#verdicts td:nth-child(4){min-width:11em}
#method td:first-child{color:var(--soft);min-width:8em;width:9em}
tr:last-child td{border-bottom:0}
tbody tr:hover td{background:var(--stripe)}
.badge{display:inline-block;border-radius:999px;padding:1px 10px;font-weight:600;font-size:.82rem;white-space:nowrap;
background:var(--none-b);color:var(--none)}
.good{background:var(--good-b);color:var(--good)}.bad{background:var(--bad-b);color:var(--bad)}
.odd{background:var(--odd-b);color:var(--odd)}
.chart svg{display:block;width:100%;height:auto;max-width:920px;min-width:560px}
.chart .scroll{border:0}
.sheet{display:grid;grid-template-columns:repeat(auto-fill,minmax(190px,1fr));gap:12px}
.sheet.large{grid-template-columns:repeat(2,1fr);max-width:920px}
.sheet div{break-inside:avoid}
.sheet img{display:block;width:100%;height:auto;border-radius:8px;background:#575e66}
.sheet span{display:block;font-size:.82rem;color:var(--soft);margin-top:4px;overflow-wrap:anywhere}
.missing{border:1px dashed var(--line);border-radius:8px;padding:30px 10px;text-align:center;color:var(--soft);
font-size:.82rem}
footer{color:var(--soft);font-size:.85rem;padding-bottom:30px}
@media(max-width:640px){header,main,footer{padding:0 10px}header{padding-top:18px}h1{font-size:1.5rem}
section{padding:16px 12px;border-radius:10px}.sheet{grid-template-columns:repeat(2,1fr);gap:8px}
.sheet.large{grid-template-columns:1fr}th,td{padding:5px 7px}td.t{min-width:9em}#verdicts td:first-child{min-width:12em}}
@media print{:root{--page:#fff;--card:#fff;--ink:#000;--soft:#333;--line:#bbb;--stripe:#fff}
body{font-size:10.5pt}header,main,footer{max-width:none;padding:0}nav{display:none}
section{border:0;padding:0;margin:0 0 18px}figure,.note,tr{break-inside:avoid}h2{break-after:avoid}
.scroll{overflow:visible;border:0}table{font-size:6.8pt}th,td{padding:2px 3px;white-space:normal}
td.t{min-width:6em}#verdicts td:first-child{min-width:12em}
.sheet{grid-template-columns:repeat(4,1fr)}.sheet.large{grid-template-columns:repeat(2,1fr)}
.badge{font-size:7pt;padding:0 5px}.chart svg{min-width:0}}
)";

}  // namespace whittle::bench
