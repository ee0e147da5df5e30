namespace Engraver.Core.Operations;

/// <summary>Shape of a tab along its contour.</summary>
public enum TabShape
{
    /// <summary>The tool rises and falls straight.</summary>
    Square,

    /// <summary>The tool rises and falls on slopes beside the tab.</summary>
    Sloped,
}
