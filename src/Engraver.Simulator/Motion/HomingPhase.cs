namespace Engraver.Simulator.Motion;

/// <summary>Stages of a homing move (galil-dmc.md C.2).</summary>
internal enum HomingPhase
{
    /// <summary>Moves at full speed until the home input changes.</summary>
    Search,
    SearchBrake,

    /// <summary>Moves back at low speed until the input changes again.</summary>
    Approach,

    /// <summary>Moves until the index pulse.</summary>
    Index,
    IndexBrake,

    /// <summary>Moves back to the position of the pulse.</summary>
    Return,
}
