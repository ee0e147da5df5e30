using System.Globalization;
using Engraver.App.Canvas;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Desk;

/// <summary>What the operator does on the canvas, as inputs of the command session.</summary>
/// <param name="cancel">Esc, once no box is being drawn.</param>
/// <param name="pointed">The cursor stands at a place of the drawing.</param>
/// <param name="menu">The right button while nothing is asked.</param>
public sealed class CanvasCommands(DesktopModel desk, Action cancel, Action<Point2D> pointed, Action menu) : ICanvasCommands
{
    public PointAim? Aim => desk.Prompt.Aim;

    public GhostOf? Preview => desk.Prompt.Preview;

    public string Asked => PromptLine.WithoutOptions(desk.Prompt.Text);

    /// <summary>Selects, and moves the tool of the playback to where the entity is cut.</summary>
    public void PickAt(Point2D place, int entity, bool remove)
    {
        _ = desk.SelectAsync(_ => [entity], remove);
        desk.Derived.MoveToEntity(entity);
    }

    public void SelectBox(Point2D from, Point2D to, bool crossing, bool remove)
    {
        var box = Bounds2D.FromCorners(from, to);
        _ = desk.SelectAsync(drawing => [.. crossing ? DrawingPick.Touching(drawing, box) : DrawingPick.Inside(drawing, box)], remove);
    }

    public void Cancel() => cancel();

    public void PointGiven(Point2D place) => _ = desk.EnterAsync(string.Create(CultureInfo.InvariantCulture, $"{place.X:R},{place.Y:R}"));

    public void ZoomExtents() => _ = desk.RunAsync("ZOOM", "Extents");

    public void Menu(Point2D place)
    {
        if (desk.Prompt.Command is not null) _ = desk.EnterAsync("");
        else menu();
    }

    public void CursorAt(Point2D? place)
    {
        if (place is { } at) pointed(at);
    }
}

/// <summary>The line of a prompt as the desktop shows it.</summary>
internal static class PromptLine
{
    /// <summary>Instruction and default without the options, which stand beside it to be clicked.</summary>
    public static string WithoutOptions(string prompt)
    {
        var open = prompt.IndexOf(" [", StringComparison.Ordinal);
        var close = open < 0 ? -1 : prompt.IndexOf(']', open);
        if (close < 0) return prompt;
        var before = prompt[..open];
        return (before.EndsWith(" or", StringComparison.Ordinal) ? before[..^3] : before) + prompt[(close + 1)..];
    }
}
