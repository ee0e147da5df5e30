namespace Engraver.Core.Drawings;

/// <summary>Where on its blank a drawing is cut.</summary>
public enum BlankPlace
{
    /// <summary>Where its coordinates put it.</summary>
    None,

    /// <summary>With the lower left corner of its curves at 0,0, the lower left corner of the blank.</summary>
    Corner,

    /// <summary>With the centre of its curves at the centre of the blank.</summary>
    Centre,
}
