namespace Engraver.Workbench.CommandLanguage;

/// <summary>What a place of the drawing is asked for: it decides how a canvas helps to point at it.</summary>
public enum PointUse
{
    /// <summary>A place, exactly: object snaps, the snap raster and ORTHO help.</summary>
    Place,

    /// <summary>A corner of a box: nothing snaps, so that it can stand beside what it is to hold.</summary>
    Corner,

    /// <summary>The object there: nothing snaps.</summary>
    Object,
}
