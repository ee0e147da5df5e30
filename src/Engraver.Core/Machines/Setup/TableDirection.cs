namespace Engraver.Core.Machines.Setup;

/// <summary>A direction of the tool over the table, as seen by the operator in front of it. The drawing's X goes right, its Y back.</summary>
public enum TableDirection
{
    Right,
    Left,

    /// <summary>Away from the operator.</summary>
    Back,

    /// <summary>Towards the operator.</summary>
    Front,
}
