using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Programs;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>Brings the machine to rest after a job, and adds to the job's end what is found there: tool, motors and position.</summary>
internal sealed class JobStandstill(ControllerSession session, JobMachine machine, JobLedger ledger, JobOptions options, OperatorStop stopper, bool isHandMove)
{
    /// <summary>Tool off, stop, the job's threads halted, at rest; after a complete job only the threads are left to stop. Tried over a lost link too,
    /// because the other handle may still work.</summary>
    /// <param name="end">How the job ended.</param>
    /// <param name="strategy">Counts what was completed of a job that ended early.</param>
    /// <returns>The end with what was found at rest, and where the machine is; null where that is not known.</returns>
    public async Task<(JobEnd End, StandstillReport? Standstill)> ReachAsync(JobEnd end, IJobStrategy strategy)
    {
        try
        {
            var standstill = await stopper.FinishAsync(options.PollInterval, CancellationToken.None).ConfigureAwait(false);
            ledger.IsStopping = end.IsEarly;
            if (end.Outcome == JobOutcome.LinkLost && machine.Frame.Taken is null) return (end, null); // it has not moved; what replies now may have been switched off in between
            if (await WasResetAsync().ConfigureAwait(false)) return (Reset(end), null);
            end = WithTool(end, standstill);
            end = WithMotors(end, await new FollowingCheck(session, machine.Profile).AtRestAsync().ConfigureAwait(false));
            var doubt = await WhyStepsMayBeLostAsync(end).ConfigureAwait(false); // before the tool goes up, which leaves another stop code
            if (end.IsEarly) await strategy.StoppedAsync(standstill.SegmentCounter).ConfigureAwait(false);
            if (isHandMove || machine.Profile is { Height: null } && Subprograms.RestOff(machine.Profile).Length == 0) return (WithDoubt(end, doubt), standstill);
            int? clearance = machine.Frame.Taken is { } frame ? frame.Z + machine.Profile.ClearanceCounts : null;
            var (rest, warning) = await new ToolRetreat(session, machine.Profile).RunAsync(standstill, clearance, end.Doubt.Length > 0, options.PollInterval).ConfigureAwait(false);
            return (WithDoubt(warning.Length == 0 ? end : end with { Sentence = $"{end.Sentence} {warning}" }, doubt), rest);
        }
        catch (ProtocolViolationException unknown) when (!session.StopHandle.IsBroken)
        {
            return (JobEnd.Broken(end.IsEarly ? $"{end.Sentence} {unknown.Message}" : unknown.Message), null);
        }
        catch (ControllerException failure)
        {
            var lost = end.Outcome == JobOutcome.LinkLost ? end : JobEnd.LinkLost(failure.Message);
            return (lost with { Sentence = lost.Sentence + LastReport }, null);
        }
    }

    /// <summary>The controller was switched off or reset since the job began: its variables are gone, and it counts from wherever the machine was. The
    /// position that it reports is of no use.</summary>
    private async ValueTask<bool> WasResetAsync() => machine.Frame.Taken is not null && await machine.Commands.AskAtRestAsync(ResidentProgram.Variables.JobMark).ConfigureAwait(false) is null;

    /// <summary>A tool that an axis drives is left where it is, because its height is not known.</summary>
    private static JobEnd Reset(JobEnd end) => (end.IsEarly ? end with { Sentence = $"{end.Sentence} {Wording.Get("Job.ControllerReset")}" } : JobEnd.Broken(Wording.Get("Job.ControllerReset"))) with { Doubt = Wording.Get("Job.ControllerResetDoubt") };

    /// <summary>A tool that was on after the job has marked the work; one that is still on has to be switched off manually.</summary>
    private static JobEnd WithTool(JobEnd end, StandstillReport standstill)
    {
        if (standstill.WasToolOn && !end.IsEarly) end = JobEnd.Deviated(Wording.Get("Job.ToolWasOn", standstill.Position.X, standstill.Position.Y));
        return standstill.IsToolOn ? end with { Sentence = $"{end.Sentence} {Wording.Get("Job.ToolStaysOn")}" } : end;
    }

    /// <summary>Motors that are not where they were sent: what was cut is not known, and from here on neither is the machine's position.</summary>
    /// <param name="off">The axes with their position errors; empty for none.</param>
    private JobEnd WithMotors(JobEnd end, string off)
    {
        if (off.Length == 0 || end.Doubt.Length > 0) return end;
        var finding = Wording.Get("Job.MotorsNotAtPosition", off);
        var ended = end.IsEarly ? end with { Sentence = $"{end.Sentence} {finding}" } : isHandMove ? JobEnd.Broken(finding) : JobEnd.Deviated(finding);
        return ended with { Doubt = Wording.Get("Job.DidNotFollow") };
    }

    /// <summary>An abort stops steppers without a ramp (galil-dmc.md D), and the steps that they lose are not counted.</summary>
    /// <returns>Empty where no steps can be lost.</returns>
    private async ValueTask<string> WhyStepsMayBeLostAsync(JobEnd end)
    {
        if (!end.IsEarly || end.Doubt.Length > 0 || machine.Frame.StartPosition is not { } start) return "";
        var place = await PositionQueries.AskAsync(session, machine.Profile.Axes).ConfigureAwait(false);
        return (StoredMachineState.Empty with { RestPosition = start }).StepLossReason(place, place.StoppedWithoutRamp);
    }

    private static JobEnd WithDoubt(JobEnd end, string why) => why.Length == 0 ? end : end with { Sentence = $"{end.Sentence} {Wording.Get("Job.PositionInDoubt", why)}", Doubt = why };

    /// <summary>What was last known. After the link is lost the controller continues without reports, with its buffer or a program with all its strokes,
    /// until the watchdog trips.</summary>
    private string LastReport => machine.Known is { } known ? Wording.Get("Job.LastReport", known.Position.X, known.Position.Y, ledger.Executed) : "";
}
