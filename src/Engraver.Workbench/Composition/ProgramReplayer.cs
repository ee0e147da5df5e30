using Engraver.Core.Diagnostics;
using Engraver.Galil.Driver;
using Engraver.Galil.Links;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Protocol;
using Engraver.Simulator;

namespace Engraver.Workbench.Composition;

/// <summary>Runs a posted program in a simulated controller of its own, in virtual time: the interpreter and the motion that judge the program share no code with what wrote it.</summary>
public static class ProgramReplayer
{
    /// <summary>A program in which nothing moves for so long is not coming to its end, seconds of controller time.</summary>
    private const int LongestRest = 60;

    /// <summary>Steps of the simulator between two looks at the stop, some tens of milliseconds.</summary>
    private const int SliceSteps = 20_000;

    private static readonly TimeSpan s_longestRest = TimeSpan.FromSeconds(LongestRest);
    private static readonly TimeSpan s_replyTimeout = TimeSpan.FromSeconds(60);

    /// <summary>Loads each chunk, starts it at #JOB and waits for its end; stops at the first that fails.</summary>
    /// <param name="program">Without diagnostics.</param>
    /// <param name="expected">How much controller time it probably takes, for the progress.</param>
    /// <param name="longest">How much controller time the whole program may take.</param>
    /// <param name="listener">Told what the motors and outputs do, from 0,0 on; nothing is kept here.</param>
    /// <exception cref="OperationCanceledException">It is not wanted any more.</exception>
    public static async Task<ProgramReplay> RunAsync(ReadBackProgram program, TimeSpan expected, TimeSpan longest, IMotionListener listener, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        await using var controller = new SimulatedController(new SimulatorOptions { Speed = double.PositiveInfinity, Time = new StandingTime(), KeepsRecord = false });
        using var listening = controller.Record.Subscribe(listener);
        await using var channel = new CommandChannel(new StreamLink(controller.OpenConnection(), Wording.Get("ProgramReplayer.SimulatedController")), "A", s_replyTimeout, TimeProvider.System, trace: null);
        for (var i = 0; i < program.Chunks.Count; i++)
        {
            var number = i + 1;
            void Report() => progress?.Report(new ReplayProgress(number, program.Chunks.Count, TimeSpan.FromMilliseconds(controller.Status.Sample), expected));
            if (await RunAsync(program.Chunks[i], controller, channel, longest, Report, cancellation).ConfigureAwait(false) is { } failure) return new ProgramReplay([failure]);
        }

        return new ProgramReplay([]);
    }

    private static async Task<Diagnostic?> RunAsync(ReadBackChunk chunk, SimulatedController controller, CommandChannel channel, TimeSpan longest, Action report, CancellationToken cancellation)
    {
        if (await ReadBackRun.StartAsync(chunk, channel, cancellation).ConfigureAwait(false) is { } unstarted) return unstarted;
        var endless = AdvanceToEnd(controller, longest, report, cancellation);
        var error = await ReadBackRun.ErrorAsync(chunk, channel, cancellation).ConfigureAwait(false);
        return error ?? (endless is null ? null : VerificationRules.Endless.At(new SourceRef(chunk.FirstLine), endless));
    }

    /// <returns>Null at the end of the program, otherwise why it is not expected any more.</returns>
    private static string? AdvanceToEnd(SimulatedController controller, TimeSpan longest, Action report, CancellationToken cancellation)
    {
        while (true)
        {
            cancellation.ThrowIfCancellationRequested();
            report();
            var (status, hasRested) = controller.AdvanceToRest(longest, s_longestRest, SliceSteps);
            if (status.IsIdle) return null;
            if (hasRested) return Wording.Get("ProgramReplayer.NothingHasMovedMachine", LongestRest);
            if (status.Sample > longest.TotalMilliseconds) return Wording.Get("ProgramReplayer.StillMovesAfterMachine", longest.TotalSeconds);
        }
    }
}
