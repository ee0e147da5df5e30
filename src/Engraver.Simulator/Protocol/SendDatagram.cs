namespace Engraver.Simulator.Protocol;

/// <summary>Sends one datagram to the client of a UDP handle.</summary>
internal delegate void SendDatagram(ReadOnlySpan<byte> bytes);
