namespace Engraver.Core.Operations;

/// <summary>Lines of a fill.</summary>
public enum FillPattern
{
    /// <summary>Parallel straight lines.</summary>
    Lines,

    /// <summary>Lines parallel to the contours, from the contours inwards.</summary>
    Contour,
}
