using Engraver.Core.Diagnostics;
using Engraver.Galil.Programs.Posting;

namespace Engraver.Workbench.Verification;

/// <summary>A posted program from a file. Whatever stands there, the answer is a program; what is wrong with it is among its diagnostics.</summary>
public static class ReadBackFile
{
    public static ReadBackProgram Open(string path)
    {
        try
        {
            return ReadBackProgram.Parse(File.ReadAllText(path));
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new ReadBackProgram([], [DocumentRules.Unreadable.At(default, unreadable.Message.TrimEnd('.'))]);
        }
    }
}
