namespace Engraver.Workbench.Views;

/// <summary>The overlays of the drawing, each with a switch (SHOW).</summary>
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

    /// <summary>Discontinuities and the findings of CHECK.</summary>
    Findings = 64,

    /// <summary>The travel of the machine.</summary>
    Machine = 128,

    /// <summary>The engraved part, in another colour than the rest.</summary>
    Engraved = 256,

    /// <summary>The recorded trace of the machine.</summary>
    Recorded = 512,

    /// <summary>The position of the drawing's zero on the machine.</summary>
    WorkOrigin = 1024,

    /// <summary>The curves of the trajectories, coloured by their deviation, with points and corners.</summary>
    Trajectories = 2048,

    /// <summary>The path of the operations, each in its own colour.</summary>
    Operations = 4096,

    All = 8191,
}
