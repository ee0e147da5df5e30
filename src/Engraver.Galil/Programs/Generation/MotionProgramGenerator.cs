using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Profiles;
using Engraver.Core.Motion;
using Engraver.Core.Sequencing;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;
using Engraver.Galil.Language;

namespace Engraver.Galil.Programs.Generation;

/// <summary>Converts a toolpath in millimetres to a motion program in counts. What the controller cannot do as drawn is converted (split, chords); what cannot
/// be converted is an error that names the entity.</summary>
/// <remarks> Every end point is the rounded drawing point. Arcs are computed from the predicted position of the controller and are within one count of the
/// drawn arc (galil-dmc.md B.3). A move shorter than a count gives no segment: its entity counts as cut when the next segment of the stroke is cut, or when the
/// stroke ends. </remarks>
public static class MotionProgramGenerator
{
    /// <summary>Generates the program for one machine.</summary>
    /// <param name="toolpath">Strokes in order, millimetres.</param>
    /// <param name="profile">The machine; a setting outside the controller's limits is an error.</param>
    /// <param name="tolerances">How far the motion may be beside the toolpath.</param>
    /// <param name="sourceOf">Position of an entity in the drawing's file, for diagnostics.</param>
    /// <param name="style">How the segments are grouped into sequences.</param>
    public static MotionGeneration Generate(
        Toolpath toolpath, MachineProfile profile, MotionTolerances tolerances, Func<int, SourceRef>? sourceOf, MotionStyle style = MotionStyle.Continuous)
    {
        var maxErrorMm = tolerances.MaxErrorMm;
        ArgumentOutOfRangeException.ThrowIfNegativeOrZero(maxErrorMm);
        ArgumentOutOfRangeException.ThrowIfNegative(tolerances.CornerMm);
        var findings = new List<Diagnostic>(MachineProfileValidation.Check(profile, DmcLimits.Machine));
        if (findings.Count > 0) return new MotionGeneration(null, findings);
        if (!IsCountable(toolpath.ToolStart, profile.Scale)) findings.Add(MotionRules.ToolStartUnusable.At(default, FactText.Of(toolpath.ToolStart.X), FactText.Of(toolpath.ToolStart.Y)));
        if (findings.Count > 0) return new MotionGeneration(null, findings);

        var start = profile.Scale.ToCounts(toolpath.ToolStart);
        SourceRef Source(int entity) => sourceOf?.Invoke(entity) ?? default;
        AddRefusals(toolpath, profile.Scale, start, Source, findings);
        if (profile.Height is { } drive) findings.AddRange(HeightFindings.Findings(toolpath, drive, profile.Scale, Source));
        var isRefused = findings.Any(finding => finding.Severity == Severity.Error);
        if (!isRefused && ChordBudget.Refusal(toolpath, profile.Scale, maxErrorMm, Source) is { } unbounded)
        {
            findings.Add(unbounded);
            isRefused = true;
        }

        if (isRefused) return new MotionGeneration(null, findings);

        if (BridgedGaps.Warning(toolpath, AllowedDeviation(profile, maxErrorMm), Source) is { } beside) findings.Add(beside);
        if (!profile.Scale.IsUniform && HasArcs(toolpath)) findings.Add(ChordsNote(profile.Scale, maxErrorMm));
        var columns = new VectorColumns(toolpath.Strokes.Sum(stroke => stroke.Moves.Count));
        var generators = new Dictionary<(double Feed, double? Plunge), StrokeGenerator>();
        var volts = (double?)null;
        foreach (var stroke in toolpath.Strokes)
        {
            var isCut = false;
            var terms = TermsOf(stroke, profile, volts);
            volts = terms?.Volts;
            var speeds = (stroke.FeedMmPerMinute ?? profile.FeedMmPerMinute, stroke.PlungeMmPerMinute ?? profile.Height?.PlungeMmPerMinute);
            if (!generators.TryGetValue(speeds, out var generator)) generators[speeds] = generator = new StrokeGenerator(WithSpeeds(profile, speeds), tolerances, style, columns);
            foreach (var lift in HeightFindings.Lifts(stroke, profile)) isCut |= generator.Generate(stroke, lift, terms);
            if (!isCut) findings.Add(MotionRules.SmallerThanACount.At(Source(stroke.Moves[0].EntityIndex), FactText.Of(stroke.Start.X), FactText.Of(stroke.Start.Y)));
        }

        if (SlowSendingWarning(generators.Values, profile, Source) is { } slow) findings.Add(slow);
        return new MotionGeneration(new MotionProgram(profile, start, columns.Strokes()) { Style = style }, findings);
    }

    /// <summary>Null where the host can send every sequence at the feed that is asked.</summary>
    private static Diagnostic? SlowSendingWarning(IReadOnlyCollection<StrokeGenerator> generators, MachineProfile profile, Func<int, SourceRef> source)
    {
        if (generators.Select(generator => generator.Slowest).OfType<SlowSending>().OrderBy(slow => slow.Speed / slow.Feed).FirstOrDefault() is not { Feed: > 0.0 } worst) return null;
        var sent = 1.0 / FeedLimit.SecondsPerSegment;
        string Feed(double countsPerSecond) => FactText.Of(Math.Round(profile.Scale.Coarser.LengthOf(60.0 * countsPerSecond), 1));
        return MotionRules.SendingTooSlow.At(
            source(worst.Entity), Feed(worst.Feed), FactText.Of(Math.Round(sent * worst.Feed / worst.Speed)), FactText.Of(Math.Round(sent)), generators.Sum(generator => generator.SlowSequences).ToString(CultureInfo.InvariantCulture), Feed(worst.Speed));
    }

    /// <summary>The machine with the speeds of a stroke.</summary>
    private static MachineProfile WithSpeeds(MachineProfile profile, (double Feed, double? Plunge) speeds) =>
        profile with { FeedMmPerMinute = speeds.Feed, Height = profile.Height is { } drive ? drive with { PlungeMmPerMinute = speeds.Plunge ?? drive.PlungeMmPerMinute } : null };

    /// <summary>Null for a stroke that does as the profile states.</summary>
    /// <param name="before">Volts of the analog output at the stroke before; null for the first one.</param>
    private static StrokeTerms? TermsOf(ToolpathStroke stroke, MachineProfile profile, double? before)
    {
        var volts = profile.Power is { } power ? power.Volts * (stroke.AnalogPart ?? 1.0) : profile.Spindle is { SpeedAxis: not null } spindle ? spindle.SpeedVolts * stroke.AnalogPart : null;
        var plunge = stroke.PlungeMmPerMinute is { } speed ? profile.PlungeSpeed(speed) : profile.PlungeSpeed();
        return plunge == profile.PlungeSpeed() && stroke is { PierceSeconds: 0.0, DwellSeconds: 0.0 } && profile.OperationOutputs == 0 && volts is null
            ? null
            : new StrokeTerms(plunge, stroke.PierceSeconds, stroke.DwellSeconds)
            {
                Outputs = profile.OperationOutputs, OutputsOn = stroke.Outputs, Volts = volts,
                ReadySeconds = profile.Power is null && before is not null && volts is not null && before != volts ? profile.Spindle!.SpinUpSeconds : 0.0,
            };
    }

    private static void AddRefusals(Toolpath toolpath, CountsScale scale, CountsPoint start, Func<int, SourceRef> source, List<Diagnostic> findings)
    {
        foreach (var stroke in toolpath.Strokes)
        {
            foreach (var move in stroke.Moves)
            {
                if (Refusal(move, scale, start, source) is { } refusal) findings.Add(refusal);
            }
        }
    }

    private static Diagnostic? Refusal(in StrokeMove move, CountsScale scale, CountsPoint start, Func<int, SourceRef> source)
    {
        var box = move.Segment.Bounds;
        if (!double.IsFinite(box.MinX + box.MinY + box.MaxX + box.MaxY)) return MotionRules.NotFinite.At(source(move.EntityIndex));
        if (scale.IsInRange(box, start)) return null;
        var x = Math.Abs(box.MinX) > Math.Abs(box.MaxX) ? box.MinX : box.MaxX;
        var y = Math.Abs(box.MinY) > Math.Abs(box.MaxY) ? box.MinY : box.MaxY;
        return MotionRules.OutsideCounts.At(source(move.EntityIndex), FactText.Of(x), FactText.Of(y), FactText.Of(scale.X.CountsPerMillimetre), FactText.Of(scale.Y.CountsPerMillimetre));
    }

    private static bool IsCountable(Point2D place, CountsScale scale) => place.IsFinite && scale.Counts(place);

    private static bool HasArcs(Toolpath toolpath) => toolpath.Strokes.Any(stroke => stroke.Moves.Any(move => move.Segment.Kind != SegmentKind.Line));

    private static double AllowedDeviation(MachineProfile profile, double maxErrorMm) => new TraceTolerances { Count = profile.Scale.Coarser.LengthOf(1.0), MaxError = maxErrorMm }.Deviation;

    private static Diagnostic ChordsNote(CountsScale scale, double maxErrorMm) =>
        MotionRules.ArcsBecomeChords.At(default, FactText.Of(scale.X.CountsPerMillimetre), FactText.Of(scale.Y.CountsPerMillimetre), FactText.Of(maxErrorMm));
}
