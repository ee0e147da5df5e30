namespace Engraver.Galil.Language;

/// <summary>The execution strategies of this driver (galil-dmc.md F.1).</summary>
public enum JobMode
{
    /// <summary>Vector sequences streamed into the segment buffer while it is executed; progress by _CS.</summary>
    Stream,

    /// <summary>As in the paper: a program in the controller is called for each entity with assigned variables; progress by seq.</summary>
    Calls,

    /// <summary>The job itself as programs in the controller, one chunk after another; progress by seq and _CS.</summary>
    Program,
}
