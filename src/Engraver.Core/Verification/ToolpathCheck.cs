using Engraver.Core.Diagnostics;
using Engraver.Core.EntityTables;
using Engraver.Core.Geometry;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;

namespace Engraver.Core.Verification;

/// <summary>Compares a toolpath with the drawing it was planned from, in both directions, before anything is sent or written. Shares no method with the
/// planning: lines and arcs are found by entity and ends, curves by evaluation.</summary>
/// <remarks>Linear in the number of unchanged segments, and n log n for the rest: curves, omitted duplicates, arcs that replace lines.</remarks>
public static class ToolpathCheck
{
    /// <summary>Maximum number of findings: one is sufficient to refuse the path.</summary>
    private const int MaxFindings = 20;

    /// <summary>Fraction by which the cut length of a curve may exceed its length, plus a multiple of the tolerance.</summary>
    private const double LongerThanCurve = 1.1;
    private const double LongerByTolerances = 20.0;

    /// <summary>Empty when the path cuts exactly what is drawn; otherwise errors (VER0020 to VER0022), one for each entity and kind, that name the
    /// entity.</summary>
    /// <param name="drawn">The analysed table as drawn, duplicates included, millimetres, all coordinates finite.</param>
    /// <param name="toolpath">The path for it, with ellipses and splines as arcs or unchanged.</param>
    /// <param name="tolerances">Allowed differences.</param>
    /// <param name="sourceOf">Position of an entity in the drawing's file.</param>
    public static IReadOnlyList<Diagnostic> Findings(EntityTable drawn, Toolpath toolpath, ToolpathTolerances tolerances, Func<int, SourceRef> sourceOf)
    {
        var findings = new Dictionary<(DiagnosticRule Rule, int Entity), Misfit>();
        var match = DrawnMatch.From(drawn, toolpath, (in last, in move) => AddJump(last, move, tolerances, findings));
        if (match.Moves.Count > 0 || match.Rows.Count > 0) AddRest(match, toolpath, tolerances, findings);
        return [.. findings.Take(MaxFindings).Select(found => Diagnostic(found.Key.Rule, found.Value, sourceOf(found.Key.Entity)))];
    }

    /// <summary>Checks the gap between two moves: the tool stays on from the first move of a stroke to the last, so the gap between two moves is cut
    /// too.</summary>
    private static void AddJump(in StrokeMove last, in StrokeMove move, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        if (last.Segment.End.IsNear(move.Segment.Start, tolerances.JoinTolerance)) return;
        var gap = last.Segment.End.DistanceTo(move.Segment.Start);
        if (gap > tolerances.JoinTolerance + tolerances.For(move.Segment)) Add(findings, VerificationRules.ToolpathExtra, move.EntityIndex, new Misfit(gap, last.Segment.End, 0.0));
    }

    private static void AddRest(DrawnMatch match, Toolpath toolpath, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        var drawing = new RepresentedRows(match.Rows, tolerances);
        foreach (var move in match.Moves)
        {
            if (findings.Count >= MaxFindings) return;
            var (off, at, allowed) = drawing.MaxDistance(move);
            if (off <= allowed) continue;
            if (double.IsFinite(off)) Add(findings, VerificationRules.ToolpathBeside, move.EntityIndex, new Misfit(off, at, allowed));
            else Add(findings, VerificationRules.ToolpathExtra, move.EntityIndex, new Misfit(move.Segment.Length, at, 0.0));
        }

        AddRepeated(match, tolerances, findings);
        AddMissing(match, toolpath, tolerances, findings);
    }

    /// <summary>Finds arcs of a curve that are cut twice: their position is correct, but their length is too large.</summary>
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

    /// <summary>Tests against the moves that replace curves and lines first, then against all moves: a duplicate is covered by its counterpart.</summary>
    private static void AddMissing(DrawnMatch match, Toolpath toolpath, ToolpathTolerances tolerances, Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings)
    {
        var standing = new CutCover(match.Moves);
        CutCover? all = null;
        foreach (var row in match.Rows)
        {
            if (findings.Count >= MaxFindings) return;
            if (standing.Missing(row.Segment, tolerances.For(row.Segment)).Length == 0.0) continue;
            all ??= new CutCover([.. toolpath.Strokes.SelectMany(stroke => stroke.Moves)]);
            var (length, first) = all.Missing(row.Segment, 2.0 * tolerances.For(row.Segment));
            if (length > 0.0) Add(findings, VerificationRules.ToolpathMissing, row.EntityIndex, new Misfit(length, first, 0.0));
        }
    }

    /// <summary>Lengths are added; of the deviations, the largest counts.</summary>
    private static void Add(Dictionary<(DiagnosticRule Rule, int Entity), Misfit> findings, DiagnosticRule rule, int entity, Misfit fault)
    {
        if (!findings.TryGetValue((rule, entity), out var known)) findings[(rule, entity)] = fault;
        else if (rule != VerificationRules.ToolpathBeside) findings[(rule, entity)] = known with { Size = known.Size + fault.Size };
        else if (fault.Size > known.Size) findings[(rule, entity)] = fault;
    }

    private static Diagnostic Diagnostic(DiagnosticRule rule, Misfit fault, SourceRef source) => rule == VerificationRules.ToolpathBeside
        ? rule.At(source, FactText.Of(fault.Size), FactText.Of(fault.At.X), FactText.Of(fault.At.Y), FactText.Of(fault.Allowed))
        : rule.At(source, FactText.Of(fault.Size), FactText.Of(fault.At.X), FactText.Of(fault.At.Y));

    private readonly record struct Misfit(double Size, Point2D At, double Allowed);
}
