namespace Engraver.Core.Drawings;

/// <summary>A curve of the drawing after every INSERT is expanded: where it is in the file, and which parts it has.</summary>
/// <remarks>Its index in <see cref="Drawing.Entities"/> is the EntityIndex that is passed with every segment and move to the controller.</remarks>
public struct DrawingEntity
{
    /// <summary>Handle as a number, 0 when the entity has none.</summary>
    public ulong Handle;

    /// <summary>Line of an ASCII DXF (byte offset of a binary one) where the entity (inside a block: the block's entity) begins.</summary>
    public int SourceLine;

    /// <summary>First part in <see cref="Drawing.Parts"/>.</summary>
    public int FirstPart;

    public int PartCount;

    /// <summary>Index into <see cref="Drawing.Layers"/>: the effective layer (block content on layer 0 takes the insert's layer).</summary>
    public int Layer;

    /// <summary>The colour as written. Inside blocks "by block" is resolved, so only an entity outside blocks can still have it.</summary>
    public DrawingColour Colour;

    /// <summary>Index into <see cref="Drawing.LineStyles"/>.</summary>
    public int LineStyle;

    /// <summary>Number of its insert, 1 is the first of <see cref="Drawing.Inserts"/>; 0 for content of model space. Of letters, minus the index of their
    /// <see cref="BlockPath"/>: their insert is not known.</summary>
    public int Insert;

    public CurveType Type;

    /// <summary>True when the entity is invisible itself (code 60) or through its insert (invisible, or on a frozen or switched-off layer).</summary>
    public bool Hidden;

    /// <summary>A closed polyline, a circle.</summary>
    public bool Closed;

    /// <summary>True when both are equal in every field.</summary>
    public static bool AreSame(in DrawingEntity one, in DrawingEntity other) =>
        one.SourceLine == other.SourceLine && one.Handle == other.Handle && one.FirstPart == other.FirstPart && one.PartCount == other.PartCount && one.Layer == other.Layer
        && one.Colour.Equals(other.Colour) && one.LineStyle == other.LineStyle && one.Insert == other.Insert && one.Type == other.Type && one.Hidden == other.Hidden && one.Closed == other.Closed;
}
