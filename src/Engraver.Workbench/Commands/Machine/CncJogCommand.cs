using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCJOG: Moves the machine with the tool off by a step, or in a direction until Enter; also during a feed hold; the job returns to its position
/// before it continues.</summary>
internal sealed class CncJogCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_distances = Keyword.List("Continuous");

    public CommandInfo Info { get; } = new("CNCJOG", CommandGroup.Machine) { StartsMotion = true, HeardDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        HandMotion.Check(context, whileHeld: true);
        var hasHeight = context.Machine.Profile.Axes.Z is not null;
        var step = await context.ValueAsync(new JogStepPrompt(Wording.Get(hasHeight ? "CncJog.SpecifyStepWithZ" : "CncJog.SpecifyStep"), hasHeight)).ConfigureAwait(false);
        var (way, height) = (step.Way, step.Height);
        if (!step.IsWhole)
        {
            switch (await context.AskAsync(new NumberPrompt(Wording.Get("CncJog.SpecifyDistance")) { Least = 0.0, Options = s_distances, Default = context.Remembered("CNCJOG", "1") }).ConfigureAwait(false))
            {
                case Answer<double>.Value { Of: var distance }:
                    context.Remember("CNCJOG", NumberPrompt.Show(distance));
                    (way, height) = (way * distance, height * distance);
                    break;
                default:
                    await HoldAsync(context, new JogVelocity(way.X, way.Y, height), cancellation).ConfigureAwait(false);
                    return;
            }
        }

        if (way.Length == 0.0 && height == 0.0) throw new CommandException(CommandFailure.Usage, Wording.Get("CncJog.StepIsZero"));
        await HandMotion.StepAsync(context, way, height, cancellation).ConfigureAwait(false);
    }

    /// <summary>Moves until the operator presses Enter or Esc, at most to the end of the travel.</summary>
    private static async Task HoldAsync(CommandContext context, JogVelocity way, CancellationToken cancellation)
    {
        if (context.IsScripted) throw new CommandException(CommandFailure.Usage, Wording.Get("CncJog.ScriptNeedsDistance"));
        HandMotion.CheckMotors(context);
        HandMotion.TellUnhomed(context);
        var speed = Math.Min(context.Machine.Profile.JogMmPerMinute, HandSpeed.Fastest(context.Machine.Profile, context.Machine.Connection.IsHomed));
        using var jog = context.Machine.Hand.Presence.Begin(way.At(speed));
        var jogging = context.Machine.Hand.JogAsync(jog, context.NewRunJournal("jog"), cancellation);
        _ = jog.Lost.ContinueWith(lost => context.Say(Wording.Get(lost.Result ? "CncJog.WindowTooLate" : "CncJog.WindowLeft"), MessageKind.Warning), CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
        try
        {
            await context.ChoiceAsync(Wording.Get("CncJog.Jogging", speed), Keyword.List("Stop"), "Stop").ConfigureAwait(false);
        }
        finally
        {
            jog.Release();
            HandMotion.Conclude(context, await jogging.ConfigureAwait(false));
        }
    }
}
