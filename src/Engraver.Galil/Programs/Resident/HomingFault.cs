namespace Engraver.Galil.Programs.Resident;

/// <summary>The reason why the homing of an axis ended early.</summary>
internal enum HomingFault
{
    None = 0,

    /// <summary>The axis was on the switch and stopped before it had left it.</summary>
    NotLeft = 1,

    /// <summary>The axis stopped before it reached the switch.</summary>
    NotFound = 2,

    /// <summary>The axis passed the switch while it braked.</summary>
    Passed = 3,

    /// <summary>The axis stopped on the way back before it had left the switch.</summary>
    NoEdge = 4,

    /// <summary>The axis stopped before an index pulse was captured.</summary>
    NoIndex = 5,

    /// <summary>The axis did not reach the end of its back-off.</summary>
    NoBackOff = 6,
}
