using System;

namespace UnityEngine;

public class UnityException : SystemException
{
    public UnityException()
    {
    }

    public UnityException(string message) : base(message)
    {
    }
}

public class MissingReferenceException : SystemException
{
    public MissingReferenceException()
    {
    }

    public MissingReferenceException(string message) : base(message)
    {
    }
}

public class MissingComponentException : SystemException
{
    public MissingComponentException()
    {
    }

    public MissingComponentException(string message) : base(message)
    {
    }
}
