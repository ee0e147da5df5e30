namespace Engraver.Core.Machines.Origins;

/// <summary>Where a job's origin comes from.</summary>
public enum OriginSource
{
    /// <summary>The active work origin.</summary>
    Work,

    /// <summary>The present position of the machine.</summary>
    Here,

    /// <summary>A machine position that was typed.</summary>
    Given,
}
