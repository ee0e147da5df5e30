namespace Engraver.Workbench.Documents;

/// <summary>Shape of the frame run around a job, tool off.</summary>
public enum FrameShape
{
    /// <summary>The axis-aligned bounding rectangle.</summary>
    Rectangle,

    /// <summary>The convex hull of the cut.</summary>
    Hull,
}
