using Engraver.Core.Machines;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;
using static Engraver.Galil.Jobs.JobMachine;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Composes the sentence for a fault that a poll showed: where it was, what was wrong, what to check. The stop follows.</summary>
internal sealed class JobFault(JobMachine machine, MotionProgram program, JobLedger ledger)
{
    /// <summary>On a serial line the session has set VF to whole numbers.</summary>
    private const string Decimals = "{F10.4}";

    /// <summary>No progress. A damaged command has the same effect as somebody who holds the motion: the job waits for something that does not come.</summary>
    public async ValueTask<JobStep> StalledAsync()
    {
        var ratio = await machine.AskAtRestAsync("_VRS" + Decimals).ConfigureAwait(false);
        var why = Wording.Get(ratio is 0.0 ? "JobFault.OverrideSetToZero" : "JobFault.CommandCorruptedOrHeld");
        return JobStep.Broken(Wording.Get("JobFault.NoProgress", machine.StandstillSeconds, Place, why));
    }

    /// <summary>The path does not have the speed that the job set: another host or program changed VS, VR or VA. What it set is left as it is. The tool is
    /// still on: the controller is asked once.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<JobStep> FeedChangedAsync()
    {
        var (planned, ratio, acceleration) = (machine.Feed.Planned!(machine.State)!.Value, machine.Hold.Ratio, machine.Profile.AccelerationCounts);
        (string Operand, double Lowest, double Highest, double Step)[] set =
        [
            ("_VSS", planned.Lowest, planned.Highest, SettingCheck.Speed),
            ("_VRS", ratio, ratio, SettingCheck.Exact),
            ("_VAS", acceleration, acceleration, SettingCheck.Acceleration),
            ("_VDS", acceleration, acceleration, SettingCheck.Acceleration),
        ];
        var (values, end) = await machine.AskAllAsync(string.Join(',', set.Select(one => one.Operand + Decimals))).ConfigureAwait(false);
        if (end.Ends) return end;
        machine.Feed.SetByOthers = [.. set.Zip(values).Where(pair => pair.Second < pair.First.Lowest - pair.First.Step || pair.Second > pair.First.Highest + pair.First.Step).Select(pair => pair.First.Operand)];
        return JobStep.Broken(Wording.Get("JobFault.FeedChanged", machine.State.PathSpeed, Place, planned.Highest * ratio, string.Join(", ", set.Zip(values, (one, value) => Text($"{one.Operand} {value}")))));
    }

    /// <summary>The watchdog in the controller saw the tool on at standstill before this program did.</summary>
    public JobStep ToolForgotten() => JobStep.Broken(
        Wording.Get("JobFault.ToolOnAtStandstill", Place));

    public JobStep ToolSwitched()
    {
        var isOn = machine.Tool.IsOutputOn(machine.State);
        return JobStep.Broken(Wording.Get(isOn ? "JobFault.ToolFoundOn" : "JobFault.ToolFoundOff", machine.Profile.ToolOutput, Place));
    }

    /// <summary>The watchdog no longer runs: the job could go on, but nothing would stop it if this computer died.</summary>
    public JobStep Unwatched() => JobStep.Broken(
        Wording.Get("JobFault.WatchdogHalted", Place));

    private string Place
    {
        get
        {
            var at = machine.State.Position;
            return program.SegmentBehind(ledger.Executed) is var (_, segment, stroke)
                ? Wording.Get("JobFault.PositionOnStroke", at.X, at.Y, program.Strokes[stroke].Index + 1, segment.EntityIndex)
                : Wording.Get("JobFault.Position", at.X, at.Y);
        }
    }

    /// <summary>Reports why the program in the controller has ended: the watchdog tripped, one of its lines was refused, or somebody halted it.</summary>
    public async ValueTask<JobStep> ProgramEndedAsync()
    {
        if (machine.State.Trip == WatchdogProgram.ToolForgotten) return ToolForgotten();
        if (machine.State.Trip != 0)
            return JobStep.LinkLost(Wording.Get("JobMachine.WatchdogTripped", machine.WatchdogSeconds), LinkLoss.Watchdog);
        if (machine.State.ProgramError == 0) return await ProgramHaltedAsync().ConfigureAwait(false);
        if (machine.State.ProgramError == SupervisedProgram.Strayed)
            return JobStep.Broken(Wording.Get("JobMachine.MotionEndedEarly", machine.State.Position.X, machine.State.Position.Y, await WhyStoppedAsync().ConfigureAwait(false)));
        if (machine.State.ProgramError == PositionErrorProgram.Code) return await CannotFollowAsync().ConfigureAwait(false);
        var (line, _) = await machine.AskAsync(ResidentProgram.Variables.ErrorLine).ConfigureAwait(false);
        var code = (TcCode)machine.State.ProgramError;
        return machine.Refuse(new Rejected(code, TcCodes.Text(code), Wording.Get("JobMachine.ProgramLine", line)), machine.PlaceInProgram((int)line));
    }

    /// <summary>Why a motion ended early, in words: the axes that a switch, an input or their error has stopped, each with its reason; where there is none,
    /// the stop code of the first axis.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<string> WhyStoppedAsync()
    {
        var stopped = new List<string>();
        foreach (var letter in machine.Profile.Axes.Letters)
        {
            if (await machine.AskAtRestAsync($"_SC{letter}").ConfigureAwait(false) is { } code && StopCodes.IsFromOutside((int)code)) stopped.Add(Wording.Get("JobMachine.AxisStopped", machine.Profile.Axes.NameOf(letter), StopCodes.Text((int)code)));
        }

        return stopped.Count == 0 ? StopCodes.Text(machine.State.StopCode) : string.Join("; ", stopped);
    }

    /// <summary>Reports a position error larger than ER: the axis is jammed, or driven faster than its motor can follow.</summary>
    private async ValueTask<JobStep> CannotFollowAsync()
    {
        var errors = new List<string>();
        foreach (var letter in machine.Profile.Axes.Letters)
        {
            if (await machine.AskAtRestAsync($"_TE{letter}").ConfigureAwait(false) is { } error) errors.Add(Wording.Get("JobMachine.AxisError", machine.Profile.Axes.NameOf(letter), error));
        }

        var switched = "";
        foreach (var letter in machine.Profile.Axes.Letters)
        {
            if (await machine.AskAtRestAsync($"_OE{letter}").ConfigureAwait(false) is 1.0 or 3.0) switched += machine.Profile.Axes.NameOf(letter);
        }

        var motors = switched.Length == 0 ? Wording.Get("JobFault.MotorsStayOn") : Wording.Get("JobFault.MotorsSwitchedOff", string.Join(", ", switched.AsEnumerable()));
        var findings = errors.Count == machine.Profile.Axes.All.Count ? $"{Wording.Get("JobMachine.FollowingErrors", string.Join(", ", errors))} {motors}" : motors;
        return JobStep.Broken(Wording.Get("JobMachine.FollowingErrorExceeded", machine.State.Position.X, machine.State.Position.Y, findings)) with { Doubt = Wording.Get("JobMachine.CouldNotFollow") };
    }

    /// <summary>Reports a halt from outside: by the abort input (galil-dmc.md D), which leaves its stop code at an axis that moved and <c>_AB</c> 0 while
    /// it is active, by AB, or by HX.</summary>
    private async ValueTask<JobStep> ProgramHaltedAsync()
    {
        var where = Wording.Get("JobFault.Position", machine.State.Position.X, machine.State.Position.Y);
        if (machine.State.StopCode == StopCodes.AbortInput || await machine.AskAtRestAsync("_AB").ConfigureAwait(false) == 0)
            return JobStep.Broken(Wording.Get("JobMachine.AbortInput", where));
        return JobStep.Broken(Wording.Get("JobMachine.ProgramHalted", StopCodes.Text(machine.State.StopCode), where));
    }
}
