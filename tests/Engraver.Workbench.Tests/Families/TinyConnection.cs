using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using Engraver.Core.Motion;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;

namespace Engraver.Workbench.Tests.Families;

/// <summary>A connected plotter. It runs jobs and reports its position; what it does not offer is refused.</summary>
internal sealed class TinyConnection(TinyChannel channel, string model, TinyDriver driver) : IMachineConnection
{
    private const string NotOffered = "The plotter does not offer this.";

    public MachineIdentity Identity { get; } = new(model, Axes: 2);

    public MachineCapabilities Capabilities { get; } = new(IsSingleWire: false);

    public bool IsBroken => false;

    public async ValueTask<MachineReading> ReadStatusAsync(MachineAxes axes, CancellationToken cancellation) => new(await PositionAsync(cancellation), default, IsMoving: false, MotorsOff: "") { Inputs = 0, Outputs = 0 };

    public async ValueTask<ControllerPosition> ReadPositionAsync(MachineAxes axes, CancellationToken cancellation)
    {
        var words = (await channel.AskAsync("AT", cancellation)).Split(' ');
        return new ControllerPosition(Point(words), Serial: 1, Mark: int.Parse(words[2], CultureInfo.InvariantCulture), Clock: 1.0) { Letters = axes.Letters };
    }

    public async ValueTask<bool> StoreMarkAsync(int mark, CancellationToken cancellation) => await channel.AskAsync(string.Create(CultureInfo.InvariantCulture, $"MARK {mark}"), cancellation) == "OK";

    public Task StopAsync(params IReadOnlyList<OutputSwitch> outputs) => channel.AskAsync("UP", CancellationToken.None);

    public Task AbortAsync(params IReadOnlyList<OutputSwitch> outputs) => StopAsync(outputs);

    public Task<MachineRefusal?> SetMotorsAsync(MachineAxes axes, bool on, CancellationToken cancellation) => Task.FromResult<MachineRefusal?>(null);

    public Task<MachineRefusal?> SetOutputAsync(int output, bool on, CancellationToken cancellation) => Task.FromResult<MachineRefusal?>(new MachineRefusal(1, NotOffered, "", NotOffered));

    public Task<IReadOnlyList<TerminalAnswer>> ExecuteLineAsync(string line, CancellationToken cancellation) => Task.FromResult<IReadOnlyList<TerminalAnswer>>([new TerminalAnswer(TerminalAnswerKind.Withheld, NotOffered)]);

    public bool TryTakeMessage([NotNullWhen(true)] out string? message) => (message = null) is not null;

    public async Task<JobResult> RunAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop)
    {
        var (frame, seconds, executed) = (options.Frame ?? await PositionAsync(stop), 0.0, 0);
        var strategy = options.Strategy ?? driver.DefaultStrategy;
        foreach (var stroke in program.Strokes)
        {
            await GoAsync(frame, stroke.Start, stop);
            if (strategy == TinyDriver.Plot) await channel.AskAsync("DOWN", stop);
            options.Polled?.Invoke(new TracePoint(seconds, stroke.Start, ToolOn: true) { Executed = executed });
            foreach (var segment in stroke.Sequences.SelectMany(sequence => sequence.Segments))
            {
                if (strategy == TinyDriver.Dash) await channel.AskAsync("DOWN", stop);
                await GoAsync(frame, segment.End, stop);
                if (strategy == TinyDriver.Dash) await channel.AskAsync("UP", stop);
                seconds += 0.1;
                options.Polled?.Invoke(new TracePoint(seconds, segment.End, ToolOn: true) { Executed = ++executed });
                progress?.Report(new JobProgress(stroke.Index, executed, executed, program.SegmentCount, segment.End, ToolOn: true, seconds));
            }

            if (strategy == TinyDriver.Plot) await channel.AskAsync("UP", stop);
        }

        var result = new JobResult
        {
            Outcome = JobOutcome.Complete,
            Message = "The drawing is plotted.",
            SegmentsSent = executed,
            SegmentsExecuted = executed,
            Seconds = seconds,
            Underruns = 0,
            Rejected = 0,
            FinalPosition = await PositionAsync(stop),
            FrameOrigin = frame,
            PolledTrace = [],
            ExecutedEntityIndices = [.. program.Strokes.SelectMany(stroke => stroke.Sequences).SelectMany(sequence => sequence.Segments).Select(segment => segment.EntityIndex).Distinct()],
            ExecutedByStroke = [.. program.Strokes.Select(stroke => stroke.SegmentCount)],
            LengthByStroke = [.. program.Strokes.Select(stroke => stroke.Sequences.Sum(sequence => sequence.Length))],
        };
        return options.Judge?.Invoke(result) ?? result;
    }

    public Task<ResumePosition> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation) => Task.FromResult(ResumePosition.Refused(NotOffered));

    public Task<JobResult> GoToAsync(MotionProgram program, CountsPoint goal, bool withHeight, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) => Task.FromResult(JobResult.NotStarted(0, NotOffered));

    public Task<JobResult> JogAsync(MotionProgram program, JogControl control, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) => Task.FromResult(JobResult.NotStarted(0, NotOffered));

    public Task<JobResult> StandByAsync(MotionProgram program, JogStandby standby, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) => Task.FromResult(JobResult.NotStarted(0, NotOffered));

    public Task<HomingResult> HomeAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) => Task.FromResult(new HomingResult(JobResult.NotStarted(0, NotOffered), null));

    public double PlannedSeconds(MotionProgram program, ExecutionStrategy strategy) => MotionTime.Calculate(program, driver.LinkTimes(null, strategy)).Total;

    public ValueTask DisposeAsync() => channel.DisposeAsync();

    private Task GoAsync(CountsPoint frame, CountsPoint to, CancellationToken cancellation) => channel.AskAsync(string.Create(CultureInfo.InvariantCulture, $"GO {frame.X + to.X} {frame.Y + to.Y}"), cancellation);

    private async Task<CountsPoint> PositionAsync(CancellationToken cancellation) => Point((await channel.AskAsync("AT", cancellation)).Split(' '));

    private static CountsPoint Point(string[] words) => new(int.Parse(words[0], CultureInfo.InvariantCulture), int.Parse(words[1], CultureInfo.InvariantCulture));
}
