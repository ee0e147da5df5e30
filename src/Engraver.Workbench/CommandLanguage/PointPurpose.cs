namespace Engraver.Workbench.CommandLanguage;

/// <summary>Purpose of a requested point. It determines the aids of the canvas.</summary>
public enum PointPurpose
{
    /// <summary>An exact point: object snap, snap grid and ORTHO apply.</summary>
    Place,

    /// <summary>A corner of a box: no snapping, because the corner is beside the objects in the box.</summary>
    Corner,

    /// <summary>The object at the point: no snapping.</summary>
    Object,
}
