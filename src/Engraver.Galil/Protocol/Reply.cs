namespace Engraver.Galil.Protocol;

/// <summary>The controller's reply to one command: <see cref="Accepted"/> or <see cref="Rejected"/> (galil-dmc.md A.3).</summary>
public abstract record Reply;
