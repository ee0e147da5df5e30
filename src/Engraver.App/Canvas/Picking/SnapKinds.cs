namespace Engraver.App.Canvas.Picking;

/// <summary>Object snaps; the numbers are those of AutoCAD's OSMODE.</summary>
[Flags]
public enum SnapKinds
{
    None = 0,
    End = 1,
    Middle = 2,
    Centre = 4,
    Quadrant = 16,
    Intersection = 32,
    All = End | Middle | Centre | Quadrant | Intersection,
}
