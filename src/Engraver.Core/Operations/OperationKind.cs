namespace Engraver.Core.Operations;

/// <summary>What an operation does with the curves that it takes.</summary>
public enum OperationKind
{
    /// <summary>The tool's centre runs on the curves.</summary>
    Engrave,

    /// <summary>The tool runs beside the contours at the distance of its radius.</summary>
    Profile,

    /// <summary>The inside of closed contours is cleared.</summary>
    Pocket,

    /// <summary>The inside of closed contours is filled with parallel lines.</summary>
    Fill,

    /// <summary>The tool moves straight down at the centres of circles.</summary>
    Drill,
}
