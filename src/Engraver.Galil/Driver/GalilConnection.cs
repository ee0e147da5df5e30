using System.Collections.Concurrent;
using System.Diagnostics.CodeAnalysis;
using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Machines.Setup;
using Engraver.Core.Motion;
using Engraver.Galil.Jobs;
using Engraver.Galil.Jobs.Journal;
using Engraver.Galil.Jobs.Timing;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Generation;
using Engraver.Galil.Programs.Timing;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;
using Engraver.Galil.Setup;
using Engraver.Galil.Terminals;

namespace Engraver.Galil.Driver;

/// <summary>A controller of the DMC family behind the machine seam.</summary>
public sealed class GalilConnection : IMachineConnection
{
    private readonly ControllerSession _session;
    private readonly ConcurrentQueue<string> _messages;
    private readonly MachineTerminal _terminal;

    private GalilConnection(ControllerSession session, ConcurrentQueue<string> messages)
    {
        _session = session;
        _messages = messages;
        _terminal = MachineTerminal.FromSession(session, messages);
    }

    public MachineIdentity Identity => _session.Identity;

    public MachineCapabilities Capabilities => new(IsSingleWire: _session.Line is not null, Jog: new SpeedRange(DmcLimits.SlowestSpeed, DmcLimits.FastestSpeed), Hold: new HoldCapability(SwitchesToolOff: true), Override: JobControl.FeedRange);

    public IMachineSetup Setup => new GalilSetup(_session);

    public bool IsBroken => _session.StopHandle.IsBroken;

    /// <summary>Opens a session and identifies the controller.</summary>
    /// <param name="openLink">Opens one more link to the same controller.</param>
    /// <param name="trace">Receives every line on the wire; null for none.</param>
    /// <exception cref="ControllerException">No reply, or not a controller of the family.</exception>
    public static async Task<GalilConnection> OpenAsync(Func<CancellationToken, Task<IControllerLink>> openLink, IWireTrace? trace, TimeProvider time, CancellationToken cancellation)
    {
        var messages = new ConcurrentQueue<string>();
        var session = await ControllerSession.OpenAsync(openLink, new SessionOptions { Trace = trace, MessageReceived = messages.Enqueue }, time, cancellation).ConfigureAwait(false);
        return new GalilConnection(session, messages);
    }

    public ValueTask<MachineReading> ReadStatusAsync(MachineAxes axes, CancellationToken cancellation) => StatusPoll.ReadAsync(_session.StopHandle, axes, cancellation);

    public ValueTask<ControllerPosition> ReadPositionAsync(MachineAxes axes, CancellationToken cancellation) => PositionQueries.AskAsync(_session.Commands, _session.Identity.Letters, axes, cancellation);

    public ValueTask<bool> StoreMarkAsync(int mark, CancellationToken cancellation) => PositionQueries.MarkAsync(_session.Commands, mark, cancellation);

    public Task StopAsync(params IReadOnlyList<OutputSwitch> outputs) => new OperatorStop(_session, outputs, [], _session.Identity.Letters).BrakeAtOnceAsync();

    /// <summary>Sends AB first: it is the only command that halts without braking (galil-dmc.md B.8). The other commands are sent even if one is
    /// refused.</summary>
    public async Task AbortAsync(params IReadOnlyList<OutputSwitch> outputs)
    {
        foreach (var command in (string[])["AB", .. outputs.Select(OperatorStop.SwitchOffCommand), "MO" + _session.Identity.Letters])
            await _session.StopHandle.SendAsync(command, CancellationToken.None).ConfigureAwait(false);
    }

    public async Task<MachineRefusal?> SetMotorsAsync(MachineAxes axes, bool on, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(axes);
        return (await _session.Commands.SendAsync((on ? "SH" : "MO") + axes.Letters, cancellation).ConfigureAwait(false) as Rejected)?.ToRefusal();
    }

    public async Task<MachineRefusal?> SetOutputAsync(int output, bool on, CancellationToken cancellation) =>
        (await _session.Commands.SendAsync(string.Create(CultureInfo.InvariantCulture, $"{(on ? "SB" : "CB")} {output}"), cancellation).ConfigureAwait(false) as Rejected)?.ToRefusal();

    public Task<IReadOnlyList<TerminalAnswer>> ExecuteLineAsync(string line, CancellationToken cancellation) => _terminal.ExecuteLineAsync(line, cancellation);

    public bool TryTakeMessage([NotNullWhen(true)] out string? message) => _messages.TryDequeue(out message);

    public async ValueTask<LinkFeedFit> FitToLinkAsync(MotionProgram program, ExecutionStrategy strategy, Func<int, SourceRef>? sourceOf, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(program);
        if (JobModes.Of(strategy) != JobMode.Stream || !program.Strokes.Any(stroke => stroke.Sequences.Any(sequence => FeedLimit.IsNeeded(sequence.Segments.Count)))) return new LinkFeedFit(program, []);
        var measured = await RoundTrip.MeasureAsync(_session.Commands, _session.Time, cancellation).ConfigureAwait(false);
        _session.ExchangeSeconds = measured;
        return _session.Line is { } line
            ? LinkFeedFitting.Create(program, line with { TurnaroundSeconds = Math.Max(line.TurnaroundSeconds, measured) }, sourceOf)
            : NetworkFeedFitting.Create(program, measured, sourceOf);
    }

    public Task<JobResult> RunAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) => JobRunner.RunAsync(program, _session, options, progress, stop);

    public Task<JobResult> GoToAsync(MotionProgram program, CountsPoint goal, bool withHeight, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) =>
        JobRunner.GoToAsync(program, goal, _session, options, progress, stop, withHeight);

    public Task<ResumePosition> FindResumeAsync(MotionProgram program, ExecutionStrategy strategy, string journal, CancellationToken cancellation) => ResumeFinder.FindAsync(_session.Commands, program, JobModes.Of(strategy), journal, cancellation);

    public Task<JobResult> JogAsync(MotionProgram program, JogControl control, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) =>
        JobRunner.JogAsync(program, control, _session, options, progress, stop);

    public Task<JobResult> StandByAsync(MotionProgram program, JogStandby standby, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) =>
        JobRunner.StandByAsync(program, standby, _session, options, progress, stop);

    public Task<HomingResult> HomeAsync(MotionProgram program, JobOptions options, IProgress<JobProgress>? progress, CancellationToken stop) =>
        JobRunner.HomeAsync(program, _session, options, progress, stop);

    public double PlannedSeconds(MotionProgram program, ExecutionStrategy strategy) => JobTime.Estimate(program, _session.Line, JobModes.Of(strategy)).Total;

    public ValueTask DisposeAsync() => _session.DisposeAsync();
}
