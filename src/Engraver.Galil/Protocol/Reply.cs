namespace Engraver.Galil.Protocol;

/// <summary>What the controller answered to one command: <see cref="Accepted"/> or <see cref="Rejected"/> (galil-dmc.md A.3).</summary>
public abstract record Reply;
