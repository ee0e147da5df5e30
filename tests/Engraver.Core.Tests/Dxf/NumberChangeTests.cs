using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.TestKit;

namespace Engraver.Core.Tests.Dxf;

/// <summary>Numbers inside curves are changed (spans, radii, ratios, places, counts), by a seed: the length of a curve never goes in silence. What it should be long is computed here by formulas of its own.</summary>
public sealed class NumberChangeTests
{
    private static readonly double[] s_spans = [0.0, 1e-7, 0.5, 90.0, 179.0, 359.99999, 360.0, 360.0000001, 360.000001, 360.01, 360.05, 360.06, 361.0, 400.0, 719.99999, 720.0, 720.000001, 720.02, 1080.0, -90.0, -360.0, -360.000001, -359.999999, -720.0, 1e6, 1e12];

    [Fact]
    public void No_change_of_a_number_loses_length_in_silence()
    {
        var random = new Random(31);
        var faults = new List<string>();
        for (var seed = 0; seed < TestExtent.Cases(400, 20_000, "ENGRAVER_FUZZ_CASES"); seed++)
        {
            var (record, written) = seed % 3 == 0 ? Ellipse(random) : Arc(random);
            var drawing = Reading.Entities([.. record]);
            var length = drawing.Parts.Count == 0 ? 0.0 : drawing.SpaceLengthOf(drawing.Parts[0]);
            var isTold = drawing.Diagnostics.Any(found => found.Severity >= Severity.Warning && found.Id is not ("DXF0003" or "DXF0009"));
            if (length < written * 0.999 && !isTold) faults.Add(string.Create(CultureInfo.InvariantCulture, $"{seed}: {string.Join(' ', record.Select(pair => $"{pair.Code}={pair.Value}"))}: {written} written, {length} read, no word"));
        }

        Assert.True(faults.Count == 0, string.Join('\n', faults));
    }

    /// <summary>The span counts as it is written up to a turn; a negative one goes the other way round the turn.</summary>
    private static double Turn(double span) => span > 0.0 ? Math.Min(span, 360.0) : span == 0.0 ? 0.0 : span % 360.0 == 0.0 ? 360.0 : 360.0 + (span % 360.0);

    private static (List<(int Code, object Value)> Record, double Written) Arc(Random random)
    {
        var (radius, start, span) = (Radius(random), 45.0 * random.Next(8), Span(random));
        return ([(0, "ARC"), (10, 3), (20, -2), (40, radius), (50, start), (51, start + span)], radius * Turn(start + span - start) * Math.PI / 180.0);
    }

    private static (List<(int Code, object Value)> Record, double Written) Ellipse(Random random)
    {
        var (major, ratio, start) = (Radius(random), Math.Pow(10.0, -3.0 * random.NextDouble()), 45.0 * random.Next(8) * Math.PI / 180.0);
        var end = Math.Round(start + (Span(random) * Math.PI / 180.0), random.Next(5, 12));
        var span = Turn((end - start) * 180.0 / Math.PI) * Math.PI / 180.0;
        var length = 0.0;
        for (var i = 0; i < 2000; i++)
        {
            var (from, to) = (start + (span * i / 2000.0), start + (span * (i + 1) / 2000.0));
            length += double.Hypot(major * (Math.Cos(to) - Math.Cos(from)), major * ratio * (Math.Sin(to) - Math.Sin(from)));
        }

        return ([(0, "ELLIPSE"), (10, 1), (20, 1), (11, major), (21, 0), (40, ratio), (41, start), (42, end)], length);
    }

    private static double Radius(Random random) => Math.Pow(10.0, (6.0 * random.NextDouble()) - 3.0);

    private static double Span(Random random) => random.Next(3) == 0 ? 720.0 * random.NextDouble() : s_spans[random.Next(s_spans.Length)];
}
