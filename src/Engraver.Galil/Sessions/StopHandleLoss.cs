namespace Engraver.Galil.Sessions;

/// <summary>The second handle was lost in the middle.</summary>
/// <param name="Reason">What cut it.</param>
/// <param name="NotReopened">Why it could not be opened again; null when it stands again.</param>
internal sealed record StopHandleLoss(string Reason, string? NotReopened);
