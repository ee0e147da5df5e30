using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Offsets;
using Engraver.Core.Trajectories;
using Engraver.Core.Trajectories.Formats;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Collects the trajectories that one command creates, and commits them as one undo step.</summary>
/// <param name="cancellation">Checked before each contour.</param>
internal sealed class TrajectoryBuilder(CommandContext context, CancellationToken cancellation)
{
    private readonly TrajectoryList _list = context.Document.Current.Sidecar.Trajectories;
    private readonly List<DocumentTrajectory> _built = [];
    private readonly List<Diagnostic> _findings = [];
    private readonly TrajectoryEdits _edits = new(context.Drawing);

    /// <summary>Lengths and points of the prompts are drawing units.</summary>
    public DrawingScale Scale { get; } = context.Drawing.Scale;

    public TrajectorySettings Settings => _list.Settings;

    /// <summary>One for each run of a contour between corners, or one for the contour; at one or several heights.</summary>
    /// <param name="name">Returns the name for a number.</param>
    public void Add(SelectedContour contour, Func<int, string> name, params IReadOnlyList<double> heights) => Add([(contour.Contour, name)], contour.Handles, heights, offset: null, default);

    /// <summary>The same for offset contours.</summary>
    /// <param name="loops">Offset loops, each with a function that returns the trajectory name for a number.</param>
    /// <param name="handles">Handles of all objects that were offset together.</param>
    /// <param name="distance">Offset, millimetres.</param>
    public void AddOffsets(IReadOnlyList<(OffsetContour Loop, Func<int, string> Name)> loops, IReadOnlyList<string> handles, double distance, OffsetSide side) => Add(loops, handles, [Settings.PlaneZ], distance, side);

    private void Add(IReadOnlyList<(OffsetContour Loop, Func<int, string> Name)> contours, IReadOnlyList<string> handles, IReadOnlyList<double> heights, double? offset, OffsetSide side)
    {
        cancellation.ThrowIfCancellationRequested();
        var runs = new List<(Trajectory Curve, Func<int, string> Name)>();
        foreach (var (contour, name) in contours)
        {
            var planned = TrajectoryPlanner.Plan(contour.Segments, contour.Closed, Settings.ToOptions());
            runs.AddRange(planned.Trajectories.Select(one => (one, name)));
            _findings.AddRange(TrajectoryFindings.NotKept(planned.Unproven, Settings.MaxErrorMm));
        }

        var (group, drawn) = (_list.NextNumber + _built.Count, _edits.FingerprintOf(handles));
        foreach (var z in heights)
        {
            for (var i = 0; i < runs.Count; i++)
            {
                var origin = drawn.Length == 0 ? null : new TrajectoryOrigin(group, i, runs.Count, drawn) { Offset = offset, Side = side, Corners = Settings.Corners };
                Add(runs[i].Curve.Moved(z), handles, runs[i].Name, origin);
            }
        }
    }

    /// <param name="origin">Null if it was not created from objects.</param>
    public void Add(Trajectory curve, IReadOnlyList<string> handles, Func<int, string> name, TrajectoryOrigin? origin = null)
    {
        var called = name(_list.NextNumber + _built.Count);
        _built.Add(new DocumentTrajectory(called, curve, Settings.MaxErrorMm) { SegmentLengthMm = Settings.DynamicDensity || curve.Heights is not null ? null : Settings.SegmentLengthMm, Handles = handles, Origin = origin });
        if (curve.VerifiedBound > Settings.MaxErrorMm) _findings.Add(TrajectoryRules.StepsTooLong.At(default, called, FactText.Of(curve.VerifiedBound), FactText.Of(Settings.MaxErrorMm)));
    }

    public void AddFindings(IEnumerable<Diagnostic> findings) => _findings.AddRange(findings);

    /// <summary>Reports the created trajectories and commits the step.</summary>
    /// <exception cref="CommandException">No trajectory was created.</exception>
    public void Commit()
    {
        FindingMessages.Write(context, context.Drawing.FileName, _findings, Severity.Warning);
        if (_built.Count == 0) throw new CommandException(CommandFailure.Drawing, Wording.Get("Trajectories.NoneMade"));
        foreach (var one in _built) context.WriteMessage(TrajectoryLine.Format(one), MessageKind.Result);
        var state = context.Document.Current;
        context.Commit(state with { Sidecar = state.Sidecar with { Trajectories = _list with { All = [.. _list.All, .. _built], NextNumber = _list.NextNumber + _built.Count } } });
    }
}

/// <summary>A trajectory in one line.</summary>
internal static class TrajectoryLine
{
    public static string Format(DocumentTrajectory one) =>
        Wording.Get("Trajectories.Line", one.Name, one.Curve.Points, NumberPrompt.Format(Math.Round(one.Curve.Length, 3)), DisplayPrecision.FormatErrorBound(one.Curve.VerifiedBound), NumberPrompt.Format(Math.Round(one.Curve.SpacingRatio, 2)), NumberPrompt.Format(one.Curve.Z));
}
