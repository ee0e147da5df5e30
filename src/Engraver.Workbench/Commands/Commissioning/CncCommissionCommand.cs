using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>CNCCOMMISSION: Determines the wiring and the motion of a machine step by step with questions and small moves, and creates a machine profile. Each
/// step can be repeated or skipped.</summary>
internal sealed class CncCommissionCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_ways = [.. Keyword.List("Go", "Skip"), new Keyword("Back") { Context = "Step" }, .. Keyword.List("End")];

    private static readonly IReadOnlyList<ICommissioningStep> s_steps = [new MotorStep(), new EncoderStep(), new SwitchStep(), new FollowingErrorStep(), new DirectionStep(), new ScaleStep(), new LetterStep(), new OutputStep()];

    /// <summary>The names of the steps in their order.</summary>
    public static IReadOnlyList<string> StepNames => [.. s_steps.Select(step => step.Name)];

    public CommandInfo Info { get; } = new("CNCCOMMISSION", CommandGroup.Machine) { StartsMotion = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is not { } address) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        if (context.IsScripted && !context.Machine.Connection.IsSimulation) throw new CommandException(CommandFailure.Usage, Wording.Get("Commission.NotInScript", address));
        if (context.Machine.IsRunning || !context.Machine.Setup.IsPossible) throw new CommandException(CommandFailure.Refused, Wording.Get("Commission.NotPossibleNow"));
        var machine = await CommissionedMachine.FindAsync(context, cancellation).ConfigureAwait(false);
        var isDone = false;
        context.Commissioning.Start();
        try
        {
            await RunStepsAsync(machine, cancellation).ConfigureAwait(false);
            await machine.RestoreMotorsAsync().ConfigureAwait(false);
            await ProfileSaving.RunAsync(machine, cancellation).ConfigureAwait(false);
            isDone = true;
        }
        finally
        {
            context.Commissioning.End();
            await machine.RestoreMotorsAsync().ConfigureAwait(false);
            machine.WriteChangedSettings(isDone);
        }
    }

    private static async Task RunStepsAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var course = machine.Context.Commissioning;
        for (var i = 0; i < s_steps.Count;)
        {
            var step = s_steps[i];
            course.Set(i, CommissioningState.InProgress);
            switch (await machine.Context.ChoiceAsync(Wording.Get("Commission.Step", i + 1, s_steps.Count, step.Name), s_ways, "Go").ConfigureAwait(false))
            {
                case "End": return;
                case "Back":
                    course.Set(i, CommissioningState.Open);
                    i = Math.Max(0, i - 1);
                    break;
                case "Skip": course.Set(i++, CommissioningState.Skipped); break;
                default:
                    var isThrough = await step.RunAsync(machine, cancellation).ConfigureAwait(false);
                    course.Set(i++, isThrough ? CommissioningState.Done : CommissioningState.Unfinished);
                    break;
            }
        }
    }
}
