using Engraver.Core.Machines;
using Engraver.Galil.Jobs.Execution;
using Engraver.Galil.Jobs.Watching;
using Engraver.Galil.Language;
using Engraver.Galil.Programs;
using Engraver.Galil.Programs.Resident;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Jobs;

/// <summary>Prepares a free controller for a job: the stop is tested, the job's program is loaded and started with its watchdog, and the settings are sent
/// and read back.</summary>
/// <param name="wait">The longest wait that an operation states, seconds.</param>
/// <param name="resident">The program in the controller for this job.</param>
/// <param name="isHandMove">A move by hand, which does not cut and leaves the mark of the last job valid.</param>
internal sealed class ControllerPreparation(ControllerSession session, MachineProfile profile, double wait, JobOptions options, ResidentProgram resident, bool isHandMove)
{
    private static readonly string[] s_settings = ["AC", "DC"];

    public async ValueTask RunAsync(JobMachine machine, ControllerSnapshot found, OperatorStop stopper)
    {
        if (!await stopper.RehearseAsync().ConfigureAwait(false)) throw JobEnd.Broken(Wording.Get("Job.StopTestFailed")).ToException();
        await JobEnd.RehearseAsync().ConfigureAwait(false);
        var mark = await MarkAsync(machine).ConfigureAwait(false);
        await session.NoteSoftLimitsAsync(options.SoftLimits, machine.Stop).ConfigureAwait(false);
        if (await found.BorrowAsync(resident.Text, machine.Stop).ConfigureAwait(false) is { } refused) throw machine.Commands.Refuse(refused, "").ToException();
        await machine.Commands.SendAllAsync(Commands(mark, machine.Frame)).ConfigureAwait(false);
        await SettingCheck.ReadBackAsync(machine, [.. s_settings.SelectMany(name => profile.Axes.Letters.Select(axis => ($"_{name}{axis}", (double)profile.AccelerationCounts, SettingCheck.Acceleration)))]).ConfigureAwait(false);
        await machine.AwaitWatchdogAsync().ConfigureAwait(false);
        if (options.Mode() != JobMode.Stream) await machine.Speed.SendRatioAsync().ConfigureAwait(false); // a stream sends it with every sequence
    }

    /// <summary>First everything is switched off and cleared that another program may have left on or selected.</summary>
    private List<string> Commands(int mark, JobCoordinates frame) =>
    [
        .. profile.OffAtAbort.Select(OperatorStop.SwitchOffCommand),
        .. Subprograms.PowerZero(profile),
        "CAS",
        ResidentServer.DefineVariables(profile, wait),
        ResidentServer.MarkCommand(mark),
        .. ResidentServer.DefineHeight(profile, frame.Given, frame.Lift, !isHandMove),
        .. session.Found.MotorsOff.Where(profile.Axes.Letters.Contains).Select(letter => $"SH{letter}"),
        .. Subprograms.AccelerationCommands(profile),
        .. session.SoftLimitCommands(options.SoftLimits),
        .. PositionErrorLimit.Commands(profile, session.Found),
        ResidentServer.StartCommand(resident),
    ];

    /// <summary>The job's own mark. A move by hand keeps that of the last job, negative: what the watchdog stores during the move belongs to no job, and
    /// the last job can still be resumed.</summary>
    private static async ValueTask<int> MarkAsync(JobMachine machine) =>
        machine.Mark != 0 ? machine.Mark : -Math.Abs((int)(await machine.Commands.AskAtRestAsync(ResidentProgram.Variables.JobMark).ConfigureAwait(false) ?? 0.0));
}
