namespace Engraver.Workbench.Views;

/// <summary>The layers of meaning over the drawing, each with a switch.</summary>
[Flags]
public enum CanvasLayers
{
    None = 0,

    /// <summary>The curves in the colours of the drawing.</summary>
    Drawing = 1,

    /// <summary>Closed or open, inside or outside.</summary>
    Contours = 2,

    OrderNumbers = 4,

    StartPoints = 8,

    /// <summary>Moves between strokes, tool off.</summary>
    Rapids = 16,

    /// <summary>The path coloured by planned speed.</summary>
    CutPath = 32,

    /// <summary>Discontinuities and the doctor's findings.</summary>
    Findings = 64,

    /// <summary>Where the machine is, and its work origin.</summary>
    Machine = 128,

    /// <summary>Engraved so far against still to do.</summary>
    Engraved = 256,

    /// <summary>Where the machine really was.</summary>
    Recorded = 512,

    All = 1023,
}
