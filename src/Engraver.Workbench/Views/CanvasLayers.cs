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

    /// <summary>The machine envelope: how far it reaches.</summary>
    Machine = 128,

    /// <summary>What is engraved so far, in another colour than what is still to do.</summary>
    Engraved = 256,

    /// <summary>Where the machine really was.</summary>
    Recorded = 512,

    /// <summary>Where the drawing's zero lies on the machine.</summary>
    WorkOrigin = 1024,

    /// <summary>The curves of the trajectories, coloured by their deviation, with points and corners.</summary>
    Trajectories = 2048,

    All = 4095,
}
