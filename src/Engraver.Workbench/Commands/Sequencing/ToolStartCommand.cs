using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Sequencing;

/// <summary>TOOLSTART: Sets the tool position at the start of the job, a point of the drawing.</summary>
internal sealed class ToolStartCommand : ICommand
{
    public CommandInfo Info { get; } = new("TOOLSTART", CommandGroup.Sequence);

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var drawing = context.Drawing;
        var now = PointPrompt.Format(drawing.Scale.ToDrawing(context.Document.Current.Settings.Start));
        var point = await context.ValueAsync(new PointPrompt(Wording.Get("ToolStart.SpecifyPoint")) { Default = now }).ConfigureAwait(false);
        var state = context.Document.Current;
        context.Commit(state with { Settings = state.Settings with { Start = drawing.Scale.ToMillimetres(point) } });
    }
}
