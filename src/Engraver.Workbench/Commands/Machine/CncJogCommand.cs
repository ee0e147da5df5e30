using Engraver.Core.Machines.Moves;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>CNCJOG: Moves the machine with the tool off by a step, or in a direction until Enter; also during a feed hold; the job returns to its position
/// before it continues.</summary>
internal sealed class CncJogCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_distances = Keyword.List("Continuous");

    public CommandInfo Info { get; } = new("CNCJOG", CommandGroup.Machine) { StartsMotion = true, IsAllowedDuringJob = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        ManualMotion.ThrowIfNotReady(context, whileHeld: true);
        var hasHeight = context.Machine.Profile.Axes.Z is not null;
        var step = await context.ValueAsync(new JogStepPrompt(Wording.Get(hasHeight ? "CncJog.SpecifyStepWithZ" : "CncJog.SpecifyStep"), hasHeight)).ConfigureAwait(false);
        var (way, height) = (step.Displacement, step.DisplacementZ);
        if (!step.HasDistance)
        {
            switch (await context.AskAsync(new NumberPrompt(Wording.Get("CncJog.SpecifyDistance")) { Min = 0.0, Options = s_distances, Default = context.LastValue("CNCJOG", "1") }).ConfigureAwait(false))
            {
                case Answer<double>.Value { Result: var distance }:
                    context.Remember("CNCJOG", NumberPrompt.Format(distance));
                    (way, height) = (way * distance, height * distance);
                    break;
                default:
                    await JogContinuouslyAsync(context, new JogVelocity(way.X, way.Y, height), cancellation).ConfigureAwait(false);
                    return;
            }
        }

        if (way.Length == 0.0 && height == 0.0) throw new CommandException(CommandFailure.Usage, Wording.Get("CncJog.StepIsZero"));
        await ManualMotion.StepAsync(context, way, height, cancellation).ConfigureAwait(false);
    }

    /// <summary>Moves until the operator presses Enter or Esc, at most to the end of the travel.</summary>
    private static async Task JogContinuouslyAsync(CommandContext context, JogVelocity way, CancellationToken cancellation)
    {
        if (context.IsScripted) throw new CommandException(CommandFailure.Usage, Wording.Get("CncJog.ScriptNeedsDistance"));
        ManualMotion.ThrowIfMotorsOff(context);
        ManualMotion.WarnUnhomed(context);
        var speed = Math.Min(context.Machine.Profile.JogMmPerMinute, HandSpeed.Max(context.Machine.Profile, context.Machine.Connection.IsHomed));
        using var jog = context.Machine.Hand.Presence.BeginJog(way.At(speed));
        var jogging = context.Machine.Hand.JogAsync(jog, context.NewRunJournal("jog"), cancellation);
        _ = jog.Abandoned.ContinueWith(lost => context.WriteMessage(Wording.Get(lost.Result ? "CncJog.WindowTooLate" : "CncJog.WindowLeft"), MessageKind.Warning), CancellationToken.None, TaskContinuationOptions.None, TaskScheduler.Default);
        try
        {
            await context.ChoiceAsync(Wording.Get("CncJog.Jogging", speed), Keyword.List("Stop"), "Stop").ConfigureAwait(false);
        }
        finally
        {
            jog.Release();
            ManualMotion.ReportResult(context, await jogging.ConfigureAwait(false));
        }
    }
}
