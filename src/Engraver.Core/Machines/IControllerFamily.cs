namespace Engraver.Core.Machines;

/// <summary>A family of controllers, as a machine profile names it.</summary>
public interface IControllerFamily
{
    /// <summary>Its name in a machine profile, lower case.</summary>
    string Key { get; }

    /// <summary>Its name for the operator.</summary>
    string Name { get; }

    /// <summary>The limits of a machine profile.</summary>
    MachineLimits Limits { get; }
}
