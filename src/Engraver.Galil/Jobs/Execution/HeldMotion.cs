namespace Engraver.Galil.Jobs.Execution;

/// <summary>The motion of a held job, which is given up where the machine has to move while the job is held: where an axis drives the tool, where the
/// operator moves the machine by hand, and where the spindle stops. The rest of the job is cut from there later.</summary>
internal static class HeldMotion
{
    /// <summary>Polls in which a sequence that was given up may still be reported as running before AB 1 ends it.</summary>
    private const int PatiencePolls = 50;

    /// <summary>Gives up what is held, at standstill. A program that runs the job is halted first, because it would continue with its next line when the
    /// sequence ends; STS then ends the sequence (galil-dmc.md B.8), and AB 1 where STS does not end what VR 0 stops.</summary>
    /// <returns>The exception to throw: the strategy ends, and the job remains held (<see cref="JobHold.AwayAsync"/>).</returns>
    public static async ValueTask<GivenUpException> GiveUpAsync(JobMachine machine)
    {
        var (phase, isInside) = (machine.Phase, machine.State.SequenceRunning);
        if (!isInside && phase.AwaitIdle is { } idle) await idle().ConfigureAwait(false);
        await machine.PollAsync().ConfigureAwait(false);
        machine.GiveUp(isInside);
        using var given = machine.Enter(phase with { Program = null });

        // First the mark: a server counts a call whose sequence is ended here, and a watchdog that trips after it would report a cut that was not made.
        await machine.Commands.SendAsync(ResidentServer.MarkCommand(-machine.Mark)).ConfigureAwait(false);
        if (phase.Program is not null) await machine.Commands.SendAsync(ResidentServer.IdleCommand).ConfigureAwait(false);
        if (isInside) await EndSequenceAsync(machine).ConfigureAwait(false);
        await machine.Commands.SendAsync("CSS").ConfigureAwait(false);
        return new GivenUpException();
    }

    private static async ValueTask EndSequenceAsync(JobMachine machine)
    {
        await machine.Commands.SendAsync("STS").ConfigureAwait(false);
        for (var polls = 0; machine.State.SequenceRunning; polls++)
        {
            if (polls == PatiencePolls) await machine.Commands.SendAsync("AB 1").ConfigureAwait(false);
            await machine.PollAsync().ConfigureAwait(false);
            if (polls > PatiencePolls) await machine.RestAsync(double.PositiveInfinity).ConfigureAwait(false);
        }

        if (machine.Phase.AwaitIdle is { } idle) await idle().ConfigureAwait(false);
    }
}
