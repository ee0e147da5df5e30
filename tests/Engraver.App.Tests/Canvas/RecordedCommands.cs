using Engraver.App.Canvas;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.App.Tests.Canvas;

/// <summary>Records the calls of the canvas.</summary>
internal sealed class RecordedCommands : ICanvasCommands
{
    public List<string> Calls { get; } = [];

    public List<Point2D> Points { get; } = [];

    public PointRequest? Aim { get; set; }

    public GhostFunction? Preview { get; set; }

    public string Instruction => "Specify a place:";

    public void PickAt(Point2D place, int entity, Drawing shown, bool remove) => Calls.Add(remove ? $"unpick {entity}" : $"pick {entity}");

    public void SelectBox(Point2D from, Point2D to, bool crossing, bool remove)
    {
        Calls.Add(crossing ? "crossing" : "window");
        Points.AddRange([from, to]);
    }

    public void Cancel() => Calls.Add("cancel");

    public void GripPressed(Point2D grip) => Calls.Add("grip");

    public void GripDropped(Point2D place) => Calls.Add("drop");

    public void PointGiven(Point2D place, bool remove)
    {
        Calls.Add(remove ? "point with shift" : "point");
        Points.Add(place);
    }

    public void ZoomExtents() => Calls.Add("extents");

    public void Menu(Point2D place) => Calls.Add("menu");

    public void CursorAt(Point2D? place)
    {
    }
}
