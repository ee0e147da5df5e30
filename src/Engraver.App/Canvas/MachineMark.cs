using Avalonia.Controls;
using Avalonia.Layout;
using Avalonia.Media;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;

namespace Engraver.App.Canvas;

/// <summary>Where the machine is and where it came from. Equal while it stands.</summary>
/// <param name="At">The machine's present place by its own zero, millimetres.</param>
/// <param name="Trail">Its last places, the latest one last; likewise.</param>
/// <param name="Zero">From the machine's own zero to the drawing's, millimetres.</param>
/// <param name="Scale">Of the drawing that is open.</param>
/// <param name="Note">Why the place is not certain in the drawing, and what to do; empty where it is.</param>
public sealed record MachineMark(Point2D At, IReadOnlyList<Point2D> Trail, Vector2D Zero, DrawingScale Scale, string Note)
{
    /// <summary>The machine's present place, drawing units.</summary>
    public Point2D Place => InDrawing(At);

    public bool IsCertain => Note.Length == 0;

    /// <summary>A place of the machine in drawing units.</summary>
    public Point2D InDrawing(Point2D place) => Scale.ToDrawing(place - Zero);
}

/// <summary>The note of an uncertain place, in the corner of the canvas.</summary>
internal sealed class MachineNote : Border
{
    private readonly TextBlock _text = new() { Name = "MachineNoteText", TextWrapping = TextWrapping.Wrap, FontSize = 12.0 };

    public MachineNote()
    {
        (Name, Child, IsHitTestVisible, IsVisible) = ("MachineNote", _text, false, false);
        (HorizontalAlignment, VerticalAlignment, MaxWidth) = (HorizontalAlignment.Left, VerticalAlignment.Top, 460.0);
        (Margin, Padding, BorderThickness, CornerRadius) = (new(10.0), new(8.0, 5.0), new(1.0), new(3.0));
        Bind(BackgroundProperty, this.GetResourceObservable("PanelBrush"));
        Bind(BorderBrushProperty, this.GetResourceObservable("WarningTextBrush"));
        _text.Bind(TextBlock.ForegroundProperty, this.GetResourceObservable("TextBrush"));
    }

    public void Show(string note) => (_text.Text, IsVisible) = (note, note.Length > 0);
}
