namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The controller whose rules apply to a program.</summary>
public enum GcodeController
{
    LinuxCnc,

    /// <summary>Without %, digital outputs, blending and absolute centres; lines of at most 79 characters; every arc names its end.</summary>
    Grbl,
}
