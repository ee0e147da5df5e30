using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Galil.Driver;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Protocol;
using Engraver.Links;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>Runs a posted DMC program in a separate simulated controller in virtual time. The simulator shares no code with the post.</summary>
public sealed class DmcReader : IProgramReader
{
    /// <summary>Time without motion, seconds of controller time, after which a program counts as stuck.</summary>
    private const int MaxSettleSeconds = 60;

    /// <summary>Simulator steps between two checks for cancellation, some tens of milliseconds of processor time.</summary>
    private const int SliceSteps = 20_000;

    private static readonly TimeSpan s_maxSettleTime = TimeSpan.FromSeconds(MaxSettleSeconds);
    private static readonly TimeSpan s_replyTimeout = TimeSpan.FromSeconds(60);

    public bool ReportsTimes => true;

    public bool RoundsCorners => true;

    /// <summary>Loads each chunk, starts it at #JOB and waits for its end; stops at the first that fails.</summary>
    public async Task<IReadOnlyList<Diagnostic>> ReplayAsync(TextReader text, ReplayRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        var program = new ReadBackProgram(text);
        var listener = new RecordListener(request.Machine, [.. request.Judges]);
        listener.Start(-(double)request.Start.X, -(double)request.Start.Y, -(double)request.Start.Z);
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new FrozenTimeProvider(), KeepsRecord = false, SerialNumber = MachineConnection.SimulatedSerialNumber });
        using var listening = controller.Record.Subscribe(listener);
        await using var channel = new CommandChannel(new StreamLink(controller.OpenConnection(), Wording.Get("DmcReader.SimulatedController")), "A", s_replyTimeout, TimeProvider.System, trace: null);
        await ReadBackRun.SetMotorsAsync(request.Machine, channel, cancellation).ConfigureAwait(false);
        for (var number = 1; ; number++)
        {
            var (chunk, fault) = program.Next();
            if (chunk is null) return fault is null ? [] : [fault];
            if (number > 1) request.Schedule?.BeginPart();
            void Report() => progress?.Report(new ReplayProgress(number, Math.Max(number, program.Count), TimeSpan.FromMilliseconds(controller.Status.Sample), request.Expected));
            if (await RunAsync(chunk, controller, channel, request.Longest, Report, cancellation).ConfigureAwait(false) is { } failure) return [failure];
        }
    }

    private static async Task<Diagnostic?> RunAsync(ReadBackChunk chunk, SimulatedController controller, CommandChannel channel, TimeSpan longest, Action report, CancellationToken cancellation)
    {
        if (await ReadBackRun.StartAsync(chunk, channel, cancellation).ConfigureAwait(false) is { } unstarted) return unstarted;
        var endless = AdvanceToEnd(controller, longest, report, cancellation);
        var error = await ReadBackRun.ErrorAsync(chunk, channel, cancellation).ConfigureAwait(false);
        return error ?? (endless is null ? null : VerificationRules.Endless.At(new SourceRef(chunk.FirstLine), endless));
    }

    /// <returns>Null at the end of the program, otherwise why the replay was aborted.</returns>
    private static string? AdvanceToEnd(SimulatedController controller, TimeSpan longest, Action report, CancellationToken cancellation)
    {
        report();
        while (true)
        {
            cancellation.ThrowIfCancellationRequested();
            var (status, hasRested) = controller.AdvanceToRest(longest, s_maxSettleTime, SliceSteps);
            report();
            if (status.IsIdle) return null;
            if (hasRested) return Wording.Get("DmcReader.NoMotion", MaxSettleSeconds);
            if (status.Sample > longest.TotalMilliseconds) return Wording.Get("DmcReader.TooLong", longest.TotalSeconds);
        }
    }
}
