namespace Engraver.App.Connections;

/// <summary>The ways to a controller that the sheet offers.</summary>
public enum LinkKind
{
    /// <summary>The controller that lives in this program.</summary>
    Simulated,

    /// <summary>TCP.</summary>
    Network,

    /// <summary>RS-232.</summary>
    Serial,
}
