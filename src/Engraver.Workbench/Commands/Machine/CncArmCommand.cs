using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCARM: Runs the start checks, and enables START for 60 s or until anything changes.</summary>
internal sealed class CncArmCommand : ICommand
{
    public CommandInfo Info { get; } = new("CNCARM", CommandGroup.Machine);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        _ = context.Drawing;
        if (await ModeAsync(context).ConfigureAwait(false) is not { } mode)
        {
            context.WriteMessage(context.Machine.Arming.Disarm() ? Wording.Get("CncArm.Disarmed") : Wording.Get("CncArm.NothingArmed"));
            return;
        }

        var armed = await JobArming.ArmAsync(context, mode, cancellation).ConfigureAwait(false);
        context.WriteMessage(Wording.Get(mode.DryRun ? "CncArm.ArmedToolOff" : "CncArm.Armed", TimeZoneInfo.ConvertTime(armed.Until, context.Time.LocalTimeZone), mode.Strategy.Keyword));
    }

    /// <returns>Null: the operator chose to disarm.</returns>
    private static async Task<ArmingMode?> ModeAsync(CommandContext context)
    {
        var (driver, dryRun, runsTrajectories) = (context.Driver, false, false);
        var remembered = driver.Strategies.FirstOrDefault(strategy => strategy.Keyword == context.LastValue("CNCARM")) ?? driver.DefaultStrategy;
        var answers = Keyword.List([.. driver.Strategies.Select(strategy => strategy.Keyword), "Dryrun", "Trajectories", "oFf"]);
        while (true)
        {
            var answer = await context.ChoiceAsync(Wording.Get(dryRun ? "CncArm.EnterModeToolOff" : "CncArm.EnterMode"), answers, remembered.Keyword).ConfigureAwait(false);
            if (answer == "oFf") return null;
            if (answer is "Dryrun" or "Trajectories")
            {
                (dryRun, runsTrajectories) = (dryRun || answer == "Dryrun", runsTrajectories != (answer == "Trajectories"));
                continue;
            }

            context.Remember("CNCARM", answer);
            return new ArmingMode(driver.Strategies.First(strategy => strategy.Keyword == answer), dryRun, runsTrajectories);
        }
    }
}
