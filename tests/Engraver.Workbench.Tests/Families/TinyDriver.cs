using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Toolpaths;

namespace Engraver.Workbench.Tests.Families;

/// <summary>A second controller family, as small as the interface allows: a plotter with axes X and Y that draws straight lines and has two strategies of its
/// own.</summary>
internal sealed class TinyDriver : IMachineDriver
{
    /// <summary>Pen down for a whole stroke.</summary>
    public static readonly ExecutionStrategy Plot = new("Plot", MotionStyle.Continuous);

    /// <summary>Pen down and up for each segment.</summary>
    public static readonly ExecutionStrategy Dash = new("dAsh", MotionStyle.Continuous);

    public string Key => "tiny";

    public string Name => "Tiny plotter";

    public MachineLimits Limits { get; } = new(1, 1_000_000, 1, 10_000_000, Outputs: 1, Axes: "XY");

    public IReadOnlyList<ExecutionStrategy> Strategies { get; } = [Plot, Dash];

    public ExecutionStrategy DefaultStrategy => Plot;

    public CommandTimes NetworkTimes { get; } = new TinyTimes();

    public string Describe(ExecutionStrategy strategy) => strategy == Plot ? "pen down for each stroke" : "pen down for each segment";

    /// <summary>Every move becomes a line between whole counts.</summary>
    public MotionGeneration Generate(Toolpath toolpath, MachineProfile profile, MotionTolerances tolerances, Func<int, SourceRef>? sourceOf, MotionStyle style)
    {
        var (columns, speed) = (new VectorColumns(16), (int)(profile.Scale.Finer.CountsOf(profile.FeedMmPerMinute / 60.0)));
        foreach (var stroke in toolpath.Strokes)
        {
            var at = profile.Scale.ToCounts(stroke.Start);
            var lines = stroke.Moves.Select(move => (move.EntityIndex, End: profile.Scale.ToCounts(move.Segment.End))).ToList();
            columns.Append(speed, profile.AccelerationCounts, [.. lines.Select((line, i) => Line(i == 0 ? at : lines[i - 1].End, line.End, line.EntityIndex) with { Move = i })], changesHeight: false);
            columns.EndStroke(stroke.Index, at);
        }

        return new MotionGeneration(new MotionProgram(profile, profile.Scale.ToCounts(toolpath.ToolStart), columns.Strokes()) { Style = style }, []);
    }

    public LinkFeedFit LimitFeedToLink(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy, Func<int, SourceRef>? sourceOf) => new(program, []);

    public double? LinkLoad(VectorSequence sequence, ControllerAddress? address, ExecutionStrategy strategy) => null;

    public CommandTimes LinkTimes(ControllerAddress? address, ExecutionStrategy strategy) => NetworkTimes;

    public async Task<IMachineConnection> OpenAsync(Func<CancellationToken, Task<IControllerLink>> openLink, IWireTrace? trace, TimeProvider time, CancellationToken cancellation)
    {
        var channel = new TinyChannel(await openLink(cancellation), trace);
        return new TinyConnection(channel, await channel.AskAsync("ID", cancellation), this);
    }

    public Task<IMachineTerminal> OpenTerminalAsync(Func<CancellationToken, Task<IControllerLink>> openLink, TimeProvider time, CancellationToken cancellation) =>
        throw new NotSupportedException("The plotter has no terminal.");

    private static VectorSegment Line(CountsPoint from, CountsPoint to, int entity) =>
        new(VectorSegmentKind.Line, to, 0, 0.0, 0.0, entity, double.Hypot(to.X - from.X, to.Y - from.Y));

    private sealed class TinyTimes : CommandTimes
    {
        public override double Sample => 0.001;

        public override double RapidSpeed(MachineProfile profile, MachineAxis axis) => profile.RapidMmPerMinute / 60.0 * Math.Abs(axis.CountsPerMillimetre);

        public override double Loading(MotionProgram program) => 0.0;

        public override double Rapid(CountsPoint from, CountsPoint to, double moving, MotionProgram program) => 0.0;

        public override double Sequence(VectorSequence sequence, double moving, MotionProgram program) => 0.0;

        public override double PlungeSpeed(MachineProfile profile) => 0.0;

        public override double Tool(CountsPoint at, bool on, double moving, MotionProgram program) => program.Profile.ToolSettleSeconds;
    }
}
