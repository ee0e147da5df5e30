using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands.View;

/// <summary>ZOOM: Shows more, less or another part of the drawing.</summary>
internal sealed class ZoomCommand : ICommand
{
    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("All", "Center", "Extents", "Previous", "Scale", "Window", "Object");

    public CommandInfo Info { get; } = new("ZOOM", CommandGroup.View) { IsTransparent = true };

    public async Task RunAsync(CommandContext context, CancellationToken cancellation)
    {
        var prompt = new ZoomPrompt(Wording.Get("Zoom.SpecifyCorner")) { Options = s_options, Default = "Extents" };
        switch (await context.AskAsync(prompt).ConfigureAwait(false))
        {
            case Answer<ZoomRequest>.Value { Result: ZoomRequest.WindowCorner corner }: await WindowAsync(context, corner.Point).ConfigureAwait(false); break;
            case Answer<ZoomRequest>.Value { Result: ZoomRequest.Scale scale }: Scale(context, scale); break;
            case Answer<ZoomRequest>.SelectedOption { Option: var option }: await ByOptionAsync(context, option).ConfigureAwait(false); break;
        }
    }

    private static async Task ByOptionAsync(CommandContext context, string option)
    {
        switch (option)
        {
            case "Center": await CenterAsync(context).ConfigureAwait(false); break;
            case "Previous": if (!context.View.ZoomPrevious()) context.WriteMessage(Wording.Get("Zoom.NoPreviousViewSaved")); break;
            case "Scale": await ScaleAsync(context).ConfigureAwait(false); break;
            case "Window": await WindowAsync(context, await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyFirstCorner")) { Purpose = PointPurpose.Corner }).ConfigureAwait(false)).ConfigureAwait(false); break;
            case "Object": await ObjectAsync(context).ConfigureAwait(false); break;
            default: Extents(context); break;
        }
    }

    private static void Extents(CommandContext context)
    {
        if (context.Document.Current.Drawing is not { } drawing || !context.View.ZoomExtents(drawing)) context.View.SetWindow(ViewState.Default.Window);
    }

    private static async Task WindowAsync(CommandContext context, Point2D first)
    {
        var second = await context.ValueAsync(new PointPrompt(Wording.Get("Common.SpecifyOppositeCorner")) { Purpose = PointPurpose.Corner, From = first }).ConfigureAwait(false);
        if (second == first) throw new CommandException(CommandFailure.Usage, Wording.Get("Zoom.WindowHasNoExtent"));
        context.View.SetWindow(Bounds2D.FromCorners(first, second));
    }

    private static async Task ObjectAsync(CommandContext context)
    {
        var selected = await ObjectSelection.GetAsync(context, takesTexts: true).ConfigureAwait(false);
        context.View.ZoomObjects(context.Drawing, selected);
    }

    private static async Task CenterAsync(CommandContext context)
    {
        var view = context.View.Current;
        var centre = await context.ValueAsync(new PointPrompt(Wording.Get("Zoom.SpecifyCenterPoint")) { Default = PointPrompt.Format(view.Centre) }).ConfigureAwait(false);
        var height = await context.ValueAsync(new NumberPrompt(Wording.Get("Zoom.EnterHeight")) { Default = NumberPrompt.Format(view.Height), Min = 1e-9, Max = 1e12 }).ConfigureAwait(false);
        context.View.SetCentre(centre, height);
    }

    private static async Task ScaleAsync(CommandContext context)
    {
        while (true)
        {
            var answer = await context.AskAsync(new ZoomPrompt(Wording.Get("Zoom.EnterScaleFactor")) { Default = "1X" }).ConfigureAwait(false);
            if (answer is not Answer<ZoomRequest>.Value { Result: ZoomRequest.Scale scale }) continue;
            Scale(context, scale);
            return;
        }
    }

    /// <summary>A factor alone is relative to the whole drawing, with X to the current view.</summary>
    private static void Scale(CommandContext context, ZoomRequest.Scale scale)
    {
        var view = context.View.Current;
        var whole = context.Document.Current.Drawing is { } drawing && context.View.ExtentsOf(drawing) is { IsEmpty: false } box
            ? Math.Max(box.Height, box.Width / view.Aspect)
            : ViewState.Default.Height;
        context.View.SetCentre(view.Centre, (scale.Relative || whole <= 0.0 ? view.Height : whole) / scale.Factor);
    }
}
