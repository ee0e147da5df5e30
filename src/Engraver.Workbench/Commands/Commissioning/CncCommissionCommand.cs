using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Commissioning;

/// <summary>CNCCOMMISSION: Determines the wiring and the motion of a machine step by step with questions and small moves, and creates a machine profile. Each
/// step can be repeated or skipped.</summary>
internal sealed class CncCommissionCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_ways = [.. Keyword.List("Go", "Skip"), new Keyword("Back") { Use = "Step" }, .. Keyword.List("End")];

    private static readonly IReadOnlyList<ICommissioningStep> s_steps = [new MotorStep(), new EncoderStep(), new SwitchStep(), new ErrorStep(), new DirectionStep(), new ScaleStep(), new LetterStep(), new OutputStep()];

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
        context.Commissioning.Begin();
        try
        {
            await GoThroughAsync(machine, cancellation).ConfigureAwait(false);
            await machine.LeaveMotorsAsFoundAsync().ConfigureAwait(false);
            await ProfileEnd.RunAsync(machine, cancellation).ConfigureAwait(false);
            isDone = true;
        }
        finally
        {
            context.Commissioning.End();
            await machine.LeaveMotorsAsFoundAsync().ConfigureAwait(false);
            machine.SayWhatStays(isDone);
        }
    }

    private static async Task GoThroughAsync(CommissionedMachine machine, CancellationToken cancellation)
    {
        var course = machine.Context.Commissioning;
        for (var i = 0; i < s_steps.Count;)
        {
            var step = s_steps[i];
            course.Set(i, CommissioningState.Now);
            switch (await machine.Context.ChoiceAsync(Wording.Get("Commission.Step", i + 1, s_steps.Count, step.Name), s_ways, "Go").ConfigureAwait(false))
            {
                case "End": return;
                case "Back":
                    course.Set(i, CommissioningState.Open);
                    i = Math.Max(0, i - 1);
                    break;
                case "Skip": course.Set(i++, CommissioningState.LeftOut); break;
                default:
                    var isThrough = await step.RunAsync(machine, cancellation).ConfigureAwait(false);
                    course.Set(i++, isThrough ? CommissioningState.Through : CommissioningState.Unfinished);
                    break;
            }
        }
    }
}

/// <summary>One step of the commissioning. It can be repeated; Enter keeps the current value.</summary>
internal interface ICommissioningStep
{
    /// <summary>Name in the question before the step.</summary>
    string Name { get; }

    /// <returns>False if the step was abandoned: a move was declined, stopped or refused, or something has to be repaired first. Accepted values
    /// remain.</returns>
    /// <exception cref="CommandException">The link or the controller failed.</exception>
    /// <exception cref="OperationCanceledException">Esc, or the operator's stop: values that were not accepted are reverted.</exception>
    Task<bool> RunAsync(CommissionedMachine machine, CancellationToken cancellation);
}
