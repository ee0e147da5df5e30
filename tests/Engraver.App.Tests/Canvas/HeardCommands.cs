using Engraver.App.Canvas;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Tests.Canvas;

/// <summary>Records the calls of the canvas.</summary>
internal sealed class HeardCommands : ICanvasCommands
{
    public List<string> Heard { get; } = [];

    public List<Point2D> Points { get; } = [];

    public PointAim? Aim { get; set; }

    public GhostOf? Preview { get; set; }

    public string Asked => "Specify a place:";

    public void PickAt(Point2D place, int entity, Drawing shown, bool remove) => Heard.Add(remove ? $"unpick {entity}" : $"pick {entity}");

    public void SelectBox(Point2D from, Point2D to, bool crossing, bool remove)
    {
        Heard.Add(crossing ? "crossing" : "window");
        Points.AddRange([from, to]);
    }

    public void Cancel() => Heard.Add("cancel");

    public void GripHeld(Point2D grip) => Heard.Add("grip");

    public void GripDropped(Point2D place) => Heard.Add("drop");

    public void PointGiven(Point2D place, bool remove)
    {
        Heard.Add(remove ? "point with shift" : "point");
        Points.Add(place);
    }

    public void ZoomExtents() => Heard.Add("extents");

    public void Menu(Point2D place) => Heard.Add("menu");

    public void CursorAt(Point2D? place)
    {
    }
}
