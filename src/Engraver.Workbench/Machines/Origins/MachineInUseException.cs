using System.Globalization;
using System.Security.Cryptography;
using System.Text;
using Engraver.Core.Languages;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Machines.Origins;

/// <summary>Another host uses the machine.</summary>
public sealed class MachineInUseException : MachineUnavailableException
{
    public MachineInUseException()
    {
    }

    public MachineInUseException(string message)
        : base(message)
    {
    }

    public MachineInUseException(string message, Exception inner)
        : base(message, inner)
    {
    }
}
