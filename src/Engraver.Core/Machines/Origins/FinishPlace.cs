namespace Engraver.Core.Machines.Origins;

/// <summary>Where the machine goes after the last stroke, tool off.</summary>
public enum FinishPlace
{
    /// <summary>The drawing's start point.</summary>
    Origin,

    /// <summary>The end of the last stroke; the machine does not move.</summary>
    Stay,

    /// <summary>The park position of the machine profile.</summary>
    Park,
}
