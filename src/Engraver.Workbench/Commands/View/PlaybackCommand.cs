using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.View;

/// <summary>PLAYBACK: Plays the planned motion, or goes to a time, row, entity, contour or program line of it; no machine moves.</summary>
internal sealed class PlaybackCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("PLay", "PAuse", "Time", "Speed", "Row", "Handle", "Contour", "Line", "?");

    public CommandInfo Info { get; } = new("PLAYBACK", CommandGroup.View) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        _ = context.Drawing;
        var derived = await context.Derivation.ForCurrentAsync(cancellation).ConfigureAwait(false);
        if (derived.Motion is not { } motion) throw new CommandException(CommandFailure.Drawing, derived.Problem ?? $"{derived.Job?.NoProgramReason}.");
        if (!ReferenceEquals(context.Playback.Motion, motion)) context.Playback.Load(motion);
        var option = await context.ChoiceAsync(Wording.Get("Common.EnterOption"), s_options, context.Playback.IsPlaying ? "PAuse" : "PLay").ConfigureAwait(false);
        switch (option)
        {
            case "PLay": context.Playback.Play(); break;
            case "PAuse": context.Playback.Pause(); break;
            case "Time": context.Playback.Scrub(await NumberAsync(context, Wording.Get("Playback.EnterTime"), context.Playback.Position, 0.0, motion.DurationSeconds).ConfigureAwait(false)); break;
            case "Speed": context.Playback.Speed = await NumberAsync(context, Wording.Get("Playback.EnterSpeed"), Math.Min(context.Playback.Speed, 1e6), 1e-3, 1e6).ConfigureAwait(false); break;
            case "?": break;
            default: await GoToAsync(context, option).ConfigureAwait(false); break;
        }

        WriteState(context);
    }

    private static async Task GoToAsync(CommandContext context, string option)
    {
        var (drawing, playback) = (context.Drawing, context.Playback);
        var found = option switch
        {
            "Row" => playback.GoToRow((int)await IntegerAsync(context, Wording.Get("Playback.EnterTableRow")).ConfigureAwait(false) - 1),
            "Contour" => playback.GoToStroke((int)await IntegerAsync(context, Wording.Get("Playback.EnterContour")).ConfigureAwait(false) - 1),
            "Line" => playback.GoToLine((int)await IntegerAsync(context, Wording.Get("Playback.EnterProgramLine")).ConfigureAwait(false)),
            _ => drawing.IndexOfHandle(await context.ValueAsync(new TextPrompt(Wording.Get("Common.EnterHandle"))).ConfigureAwait(false)) is { } entity && playback.GoToEntity(entity),
        };
        if (!found) throw new CommandException(CommandFailure.Usage, Wording.Get("Playback.NotCut"));
    }

    private static Task<double> IntegerAsync(CommandContext context, string instruction) => context.ValueAsync(new NumberPrompt(instruction) { Min = 1, Max = int.MaxValue, IsInteger = true });

    private static Task<double> NumberAsync(CommandContext context, string instruction, double now, double min, double max) =>
        context.ValueAsync(new NumberPrompt(instruction) { Default = NumberPrompt.Format(Math.Clamp(now, min, max)), Min = min, Max = max });

    private static void WriteState(CommandContext context)
    {
        if (context.Playback.Moment is not { } at) return;
        context.WriteMessage(Wording.Get("Playback.Position", at.Seconds, context.Playback.Motion!.DurationSeconds, PointPrompt.Format(at.Position), at.Speed, at.ToolOn ? Wording.Get("Common.On") : Wording.Get("Common.Off"), at.Stroke + 1, at.Row + 1, context.Playback.Motion!.LineOf(at.Segment)), MessageKind.Result);
    }
}
