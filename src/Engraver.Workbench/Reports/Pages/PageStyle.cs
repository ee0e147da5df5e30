namespace Engraver.Workbench.Reports.Pages;

/// <summary>How a page looks, on a screen and on paper: black on white, nothing cut off, nothing fetched from elsewhere.</summary>
internal static class PageStyle
{
    /// <summary>Sizes for A4. The pictures bring the colours of a dark canvas; here they get those of paper.</summary>
    public const string Css = """
        :root { color-scheme: light; }
        * { box-sizing: border-box; }
        body { margin: 0 auto; padding: 24px; max-width: 1000px; background: #fff; color: #000; font: 14px/1.45 'DejaVu Sans', Verdana, Arial, sans-serif; }
        h1 { font-size: 24px; margin: 0 0 2px; overflow-wrap: anywhere; }
        h2 { font-size: 16px; margin: 26px 0 8px; padding-bottom: 3px; border-bottom: 2px solid #000; break-after: avoid; }
        p { margin: 4px 0; overflow-wrap: anywhere; }
        table { border-collapse: collapse; width: 100%; }
        th, td { text-align: left; vertical-align: top; padding: 3px 10px 3px 0; border-bottom: 1px solid #c4c9cf; overflow-wrap: anywhere; }
        th { font-weight: 600; }
        tr { break-inside: avoid; }
        .quiet { color: #4a4f55; }
        .number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
        .pair th { width: 36%; font-weight: 400; color: #33383d; }
        .pair .number { text-align: left; }
        .sheet .pair th { width: 66%; }
        .sheet .pair .number { text-align: right; padding-right: 0; }
        .mark { width: 64px; font-weight: 700; white-space: nowrap; }
        .verdict { display: inline-block; margin: 10px 0 2px; padding: 4px 12px; border: 2px solid #000; font-weight: 700; }
        .sheet { display: grid; grid-template-columns: 1fr 1fr; gap: 0 32px; }
        .code { font: 11px/1.4 'DejaVu Sans Mono', monospace; overflow-wrap: anywhere; }
        figure { margin: 8px 0 0; break-inside: avoid; border: 1px solid #c4c9cf; }
        figure svg { display: block; width: 100%; height: auto; max-height: 235mm; }
        .picture .field { fill: #fff; } .picture .caption { fill: #f1f3f5; } .picture text { fill: #000; }
        .picture .closed { stroke: #0b5cad; } .picture .open { stroke: #a85400; } .picture .base { stroke: #c4c9cf; }
        .picture .rapid { stroke: #c02f2c; stroke-opacity: 1; } .picture .start { stroke: #1a7f37; }
        .picture .number { fill: #000; stroke: #fff; } .picture .arrow.closed { fill: #0b5cad; stroke: none; } .picture .arrow.open { fill: #a85400; stroke: none; }
        .chart text { fill: #000; font: 11px 'DejaVu Sans', Verdana, sans-serif; } .chart .grid { stroke: #d5d9dd; fill: none; }
        .chart .cutting { fill: #0b5cad; fill-opacity: .18; stroke: #0b5cad; stroke-width: 1.2; } .chart .moving { fill: none; stroke: #c02f2c; stroke-width: 1; stroke-dasharray: 4 3; }
        @page { size: A4; margin: 14mm; }
        @media print { body { padding: 0; max-width: none; font-size: 10.5pt; } h1 { font-size: 17pt; } h2 { font-size: 12pt; margin-top: 14pt; } * { -webkit-print-color-adjust: exact; print-color-adjust: exact; } }
        @media (max-width: 640px) { .sheet { grid-template-columns: 1fr; } }
        """;
}
