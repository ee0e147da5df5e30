namespace Engraver.Galil.Sessions;

/// <summary>The second handle was lost during a session.</summary>
/// <param name="Reason">Why it was lost.</param>
/// <param name="NotReopened">Why it could not be opened again; null when it is open again.</param>
internal sealed record StopHandleLoss(string Reason, string? NotReopened);
