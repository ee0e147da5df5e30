namespace Engraver.Galil.Language;

/// <summary>The controller's letters of its axes (galil-dmc.md B.1).</summary>
internal static class DmcAxes
{
    /// <summary>Every letter there is; a controller of four axes has the first four.</summary>
    public const string All = "ABCDEFGH";

    /// <summary>The axes that a job moves: the drawing's X and Y, in this order.</summary>
    public const string Plane = "AB";
}
