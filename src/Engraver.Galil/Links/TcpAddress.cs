namespace Engraver.Galil.Links;

public sealed record TcpAddress(string Host, int Port) : ControllerAddress;
