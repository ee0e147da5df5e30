using System.Globalization;

namespace Engraver.Core.Machines;

public sealed record TcpAddress(string Host, int Port) : ControllerAddress
{
    public override string Typed => string.Create(CultureInfo.InvariantCulture, $"tcp://{Host}:{Port}");
}
