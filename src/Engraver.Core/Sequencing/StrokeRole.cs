namespace Engraver.Core.Sequencing;

/// <summary>What a move of a stroke is for.</summary>
public enum StrokeRole : byte
{
    /// <summary>It cuts what is drawn, or the path beside it.</summary>
    Cut,

    /// <summary>It leads to a contour or away from it.</summary>
    Lead,

    /// <summary>It leaves a tab, or moves up to it or down from it.</summary>
    Tab,

    /// <summary>It descends along the path to the depth of its pass.</summary>
    Ramp,
}
