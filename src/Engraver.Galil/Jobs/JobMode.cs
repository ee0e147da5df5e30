namespace Engraver.Galil.Jobs;

/// <summary>How a job is run on the controller (galil-dmc.md F.1).</summary>
public enum JobMode
{
    /// <summary>Vector sequences fed live into the segment buffer; progress by _CS.</summary>
    Stream,

    /// <summary>The paper's way: a program in the controller is called for each entity with assigned variables; progress by seq.</summary>
    Calls,

    /// <summary>The job itself as programs in the controller, one chunk after the other; progress by seq and _CS.</summary>
    Program,
}
