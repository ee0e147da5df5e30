using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Verification;

/// <summary>Holds a toolpath against the drawing it was planned from, both ways, before anything is sent or written. Shares nothing with the planning: lines and arcs are found by entity and ends, curves by evaluation.</summary>
/// <remarks>Linear in the number of segments for what passes unchanged, and n log n for the rest: curves, what was left out as a duplicate, arcs that stand for lines.</remarks>
public static class ToolpathCheck
{
    /// <summary>No more are looked for: one is enough to refuse the path.</summary>
    private const int MostFindings = 20;

    /// <summary>A curve may be cut by so much more than its length, and by this many times the tolerance.</summary>
    private const double LongerThanCurve = 1.1;
    private const double LongerByTolerances = 20.0;

    /// <summary>Empty when the path cuts what is drawn and nothing else; otherwise errors (VER0020 to VER0022), one for each entity and kind, that name the entity.</summary>
    /// <param name="drawn">The analysed table as drawn, millimetres, all coordinates finite: duplicates are in it.</param>
    /// <param name="toolpath">What is to be cut for it. Ellipses and splines may stand in it as arcs or as they are.</param>
    /// <param name="tolerances">What may differ on purpose.</param>
    /// <param name="sourceOf">Where an entity stands in the drawing.</param>
    public static IReadOnlyList<Diagnostic> Findings(EntityTable drawn, Toolpath toolpath, ToolpathTolerances tolerances, Func<int, SourceRef> sourceOf)
    {
        var findings = new Dictionary<(DiagnosticRule Rule, int Entity), Misfit>();
        var match = DrawnMatch.From(drawn, toolpath);
        AddJumps(toolpath, tolerances, findings);
        if (match.Moves.Count > 0 || match.Rows.Count > 0) AddRest(match, toolpath, tolerances, findings);
        return [.. findings.Take(MostFindings).Select(found => Diagnostic(found.Key.Rule, found.Value, sourceOf(found.Key.Entity)))];
    }

    /// <summary>The tool stays down from the first move of a stroke to the last, so what lies between two moves is cut.</summary>
    private static void AddJumps(Toolpath toolpath, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        foreach (var stroke in toolpath.Strokes)
        {
            StrokeMove? before = null;
            foreach (var move in stroke.Moves)
            {
                if (before is { } last && last.Segment.End.DistanceTo(move.Segment.Start) is var gap && gap > tolerances.JoinTolerance + tolerances.For(move.Segment))
                    Add(findings, VerificationRules.ToolpathExtra, move.EntityIndex, new Misfit(gap, last.Segment.End, 0.0));
                before = move;
            }
        }
    }

    private static void AddRest(DrawnMatch match, Toolpath toolpath, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        var drawing = new DrawnRest(match.Rows, tolerances);
        foreach (var move in match.Moves)
        {
            if (findings.Count >= MostFindings) return;
            var (off, at, allowed) = drawing.Stray(move);
            if (off <= allowed) continue;
            if (double.IsFinite(off)) Add(findings, VerificationRules.ToolpathBeside, move.EntityIndex, new Misfit(off, at, allowed));
            else Add(findings, VerificationRules.ToolpathExtra, move.EntityIndex, new Misfit(move.Segment.Length, at, 0.0));
        }

        AddRepeated(match, tolerances, findings);
        AddMissing(match, toolpath, tolerances, findings);
    }

    /// <summary>Arcs of a curve that are cut twice lie where they should; their length tells.</summary>
    private static void AddRepeated(DrawnMatch match, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        var lengths = new Dictionary<int, double>();
        foreach (var row in match.Rows)
        {
            var allowed = row.Segment.IsFreeCurve ? (LongerThanCurve * row.Segment.Length) + (LongerByTolerances * tolerances.For(row.Segment)) : double.PositiveInfinity;
            lengths[row.EntityIndex] = lengths.GetValueOrDefault(row.EntityIndex) + allowed;
        }

        foreach (var move in match.Moves)
        {
            if (!lengths.TryGetValue(move.EntityIndex, out var left)) continue;
            lengths[move.EntityIndex] = left -= move.Segment.Length;
            if (left < 0.0) Add(findings, VerificationRules.ToolpathExtra, move.EntityIndex, new Misfit(Math.Min(move.Segment.Length, -left), move.Segment.Start, 0.0));
        }
    }

    /// <summary>First by what stands for curves and lines, then by everything that is cut: a duplicate is covered by what it doubles.</summary>
    private static void AddMissing(DrawnMatch match, Toolpath toolpath, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        var standing = new CutCover(match.Moves);
        CutCover? all = null;
        foreach (var row in match.Rows)
        {
            if (findings.Count >= MostFindings) return;
            if (standing.Missing(row.Segment, tolerances.For(row.Segment)).Length == 0.0) continue;
            all ??= new CutCover([.. toolpath.Strokes.SelectMany(stroke => stroke.Moves)]);
            var (length, first) = all.Missing(row.Segment, 2.0 * tolerances.For(row.Segment));
            if (length > 0.0) Add(findings, VerificationRules.ToolpathMissing, row.EntityIndex, new Misfit(length, first, 0.0));
        }
    }

    /// <summary>Lengths add up; of deviations the largest counts.</summary>
    private static void Add(Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings, DiagnosticRule rule, int entity, Misfit fault)
    {
        if (!findings.TryGetValue((rule, entity), out var known)) findings[(rule, entity)] = fault;
        else if (rule != VerificationRules.ToolpathBeside) findings[(rule, entity)] = known with { Size = known.Size + fault.Size };
        else if (fault.Size > known.Size) findings[(rule, entity)] = fault;
    }

    private static Diagnostic Diagnostic(DiagnosticRule rule, Misfit fault, SourceRef source) => rule == VerificationRules.ToolpathBeside
        ? rule.At(source, Text(fault.Size), Text(fault.At.X), Text(fault.At.Y), Text(fault.Allowed))
        : rule.At(source, Text(fault.Size), Text(fault.At.X), Text(fault.At.Y));

    private static string Text(double value) => value.ToString("0.######", CultureInfo.InvariantCulture);

    private readonly record struct Misfit(double Size, Point2D At, double Allowed);
}
