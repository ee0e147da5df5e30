using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Protocol;

namespace Engraver.Galil.Jobs.Watching;

/// <summary>Composes the end of a job for a fault that a poll showed: where it was, what was wrong, what to check. The stop follows.</summary>
internal sealed class JobFault(JobMachine machine, MotionProgram program, JobLedger ledger)
{
    /// <summary>On a serial line the session has set VF to whole numbers.</summary>
    private const string Decimals = "{F10.4}";

    /// <summary>No progress. A corrupted command has the same effect as another host that stops the motion: the job waits for something that does not
    /// happen.</summary>
    /// <param name="seconds">Controller seconds without progress.</param>
    public async ValueTask<JobEnd> StalledAsync(double seconds)
    {
        var ratio = await machine.Commands.AskAtRestAsync("_VRS" + Decimals).ConfigureAwait(false);
        var why = Wording.Get(ratio is 0.0 ? "JobFault.OverrideSetToZero" : "JobFault.CommandCorruptedOrHeld");
        return JobEnd.Broken(Wording.Get("JobFault.NoProgress", seconds, Place, why));
    }

    /// <summary>The path does not have the speed that the job set: another host or program changed VS, VR or VA. What it set is left as it is. The tool is
    /// still on, so the controller is queried only once.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<JobEnd> FeedChangedAsync()
    {
        var (planned, ratio) = (machine.Phase.Speed!(machine.State)!.Value, machine.Speed.Ratio);
        (string Operand, double Lowest, double Highest, double Step)[] set =
        [
            ("_VSS", planned.LowestSetting, planned.HighestSetting, SettingCheck.Speed),
            ("_VRS", ratio, ratio, SettingCheck.Exact),
            ("_VAS", planned.LowestAcceleration, planned.HighestAcceleration, SettingCheck.Acceleration),
            ("_VDS", planned.LowestAcceleration, planned.HighestAcceleration, SettingCheck.Acceleration),
        ];
        var values = await machine.Commands.AskAllAsync(string.Join(',', set.Select(one => one.Operand + Decimals))).ConfigureAwait(false);
        machine.Watch.Feed.SetByOthers = [.. set.Zip(values).Where(pair => pair.Second < pair.First.Lowest - pair.First.Step || pair.Second > pair.First.Highest + pair.First.Step).Select(pair => pair.First.Operand)];
        return JobEnd.Broken(Wording.Get("JobFault.FeedChanged", machine.State.PathSpeed, Place, planned.Highest * ratio, string.Join(", ", set.Zip(values, (one, value) => DmcFormat.Text($"{one.Operand} {value}")))));
    }

    /// <summary>The watchdog in the controller saw the tool on at standstill before this program did.</summary>
    private JobEnd ToolForgotten() => JobEnd.Broken(Wording.Get("JobFault.ToolOnAtStandstill", Place));

    public JobEnd ToolSwitched()
    {
        var isOn = machine.Tool.IsOutputOn(machine.State);
        return JobEnd.Broken(Wording.Get(isOn ? "JobFault.ToolFoundOn" : "JobFault.ToolFoundOff", machine.Profile.ToolOutput, Place));
    }

    /// <summary>The watchdog no longer runs: the job could continue, but nothing would stop it if this computer failed.</summary>
    public JobEnd Unwatched() => JobEnd.Broken(Wording.Get("JobFault.WatchdogHalted", Place));

    private string Place
    {
        get
        {
            var at = machine.State.Position;
            return program.SegmentAfter(ledger.Executed) is var (start, segment, stroke)
                ? Wording.Get("JobFault.PositionOnStroke", at.X, at.Y, program.Strokes[stroke].Index + 1, segment.EntityAt(segment.Shares is null ? 0.0 : new SegmentPath(start, segment).LengthTo(new Point2D(at.X, at.Y), 0.0)))
                : Wording.Get("JobFault.Position", at.X, at.Y);
        }
    }

    /// <summary>Reports why the program in the controller has ended: the watchdog tripped, one of its lines was refused, a motion ended early, or another
    /// host halted it.</summary>
    public async ValueTask<JobEnd> ProgramEndedAsync()
    {
        var end = await WhyProgramEndedAsync().ConfigureAwait(false);
        return machine.State.ProgramError == SupervisedProgram.EndedEarlyCode ? end with { Sentence = end.Sentence + machine.Phase.Place(machine.State) } : end;
    }

    private async ValueTask<JobEnd> WhyProgramEndedAsync()
    {
        if (machine.State.Trip == WatchdogProgram.ToolForgotten) return ToolForgotten();
        if (machine.State.Trip != 0)
            return JobEnd.LinkLost(Wording.Get("JobMachine.WatchdogTripped", machine.Commands.WatchdogSeconds), LinkLoss.Watchdog);
        if (machine.State.ProgramError == 0) return await ProgramHaltedAsync().ConfigureAwait(false);
        if (machine.State.ProgramError == SupervisedProgram.EndedEarlyCode)
            return JobEnd.Broken(Wording.Get("JobMachine.MotionEndedEarly", machine.State.Position.X, machine.State.Position.Y, await WhyStoppedAsync().ConfigureAwait(false)));
        if (machine.State.ProgramError == PositionErrorProgram.Code) return await CannotFollowAsync().ConfigureAwait(false);
        var line = await machine.Commands.TryAskAsync(ResidentProgram.Variables.ErrorLine).ConfigureAwait(false) ?? 0.0;
        var code = (TcCode)machine.State.ProgramError;
        return machine.Commands.Refuse(new Rejected(code, TcCodes.Text(code), Wording.Get("JobMachine.ProgramLine", line)), machine.Phase.Program?.PlaceOf((int)line) ?? "");
    }

    /// <summary>Why a motion ended early, in words: the axes that a switch, an input or their position error has stopped, each with its reason; where
    /// there is none, the stop code of the first axis.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public async ValueTask<string> WhyStoppedAsync()
    {
        var stopped = new List<string>();
        foreach (var letter in machine.Profile.Axes.Letters)
        {
            if (await machine.Commands.AskAtRestAsync($"_SC{letter}").ConfigureAwait(false) is { } code && StopCodes.IsFromOutside((int)code)) stopped.Add(Wording.Get("JobMachine.AxisStopped", machine.Profile.Axes.NameOf(letter), StopCodes.Text((int)code)));
        }

        return stopped.Count == 0 ? StopCodes.Text(machine.State.StopCode) : string.Join("; ", stopped);
    }

    /// <summary>Reports a position error larger than ER: the axis is jammed, or driven faster than its motor can follow.</summary>
    private async ValueTask<JobEnd> CannotFollowAsync()
    {
        var errors = new List<string>();
        foreach (var letter in machine.Profile.Axes.Letters)
        {
            if (await machine.Commands.AskAtRestAsync($"_TE{letter}").ConfigureAwait(false) is { } error) errors.Add(Wording.Get("JobMachine.AxisError", machine.Profile.Axes.NameOf(letter), error));
        }

        var switched = "";
        foreach (var letter in machine.Profile.Axes.Letters)
        {
            if (await machine.Commands.AskAtRestAsync($"_OE{letter}").ConfigureAwait(false) is 1.0 or 3.0) switched += machine.Profile.Axes.NameOf(letter);
        }

        var motors = switched.Length == 0 ? Wording.Get("JobFault.MotorsStayOn") : Wording.Get("JobFault.MotorsSwitchedOff", string.Join(", ", switched.AsEnumerable()));
        var findings = errors.Count == machine.Profile.Axes.All.Count ? $"{Wording.Get("JobMachine.FollowingErrors", string.Join(", ", errors))} {motors}" : motors;
        return JobEnd.Broken(Wording.Get("JobMachine.FollowingErrorExceeded", machine.State.Position.X, machine.State.Position.Y, findings)) with { Doubt = Wording.Get("JobMachine.CouldNotFollow") };
    }

    /// <summary>Reports a halt by something else than this job: by the abort input (galil-dmc.md D), which leaves its stop code at an axis that moved and
    /// <c>_AB</c> 0 while it is active, by AB, or by HX.</summary>
    private async ValueTask<JobEnd> ProgramHaltedAsync()
    {
        var where = Wording.Get("JobFault.Position", machine.State.Position.X, machine.State.Position.Y);
        if (machine.State.StopCode == StopCodes.AbortInput || await machine.Commands.AskAtRestAsync("_AB").ConfigureAwait(false) == 0)
            return JobEnd.Broken(Wording.Get("JobMachine.AbortInput", where));
        return JobEnd.Broken(Wording.Get("JobMachine.ProgramHalted", StopCodes.Text(machine.State.StopCode), where));
    }
}
