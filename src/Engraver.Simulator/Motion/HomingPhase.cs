namespace Engraver.Simulator.Motion;

/// <summary>Where a homing move is (galil-dmc.md C.2).</summary>
internal enum HomingPhase
{
    /// <summary>At full speed until the home input changes.</summary>
    Search,
    SearchBrake,

    /// <summary>Back, slowly, until the input changes again.</summary>
    Approach,

    /// <summary>Until the index pulse.</summary>
    Index,
    IndexBrake,

    /// <summary>Back to where the pulse was.</summary>
    Return,
}
